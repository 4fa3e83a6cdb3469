//! What the caller does with rays, and so what he has to get: the uses of rays in thesis H, chapter 2.

use super::form::Output;
use crate::scene::rays::Asked;

/// A use of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// Pictures: the nearest hit of a camera's rays, with u and v (H 2.1).
    Raytracing,
    /// Whether anything is before a light (H 2.1).
    Shadow,
    /// Where a small and fast thing hits: short segments, few of them (H 2.3).
    Collision,
    /// Whether one point sees another: segments, few of them (H 2.4).
    Visibility,
    /// Form factors: whether patches see each other, all pairs of them (H 2.5).
    Radiosity,
}

/// Where rays come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// Of a camera, of its hit points, of the ball around the mesh, of a file.
    Rays(Asked),
    /// From a random point of the mesh's box in a random direction, an eighth of the diagonal long.
    Steps,
    /// From a random point of the mesh's box to another.
    Sights,
    /// Between the centres of patches that face each other.
    Patches,
}

impl Use {
    /// What the caller needs of a hit.
    pub fn needs(self) -> Output {
        match self {
            Use::Raytracing => Output::Tuv,
            Use::Collision => Output::T,
            Use::Shadow | Use::Visibility | Use::Radiosity => Output::Hit,
        }
    }

    /// Its rays, where none are asked for.
    pub fn source(self) -> Source {
        match self {
            Use::Raytracing => Source::Rays(Asked::Primary),
            Use::Shadow => Source::Rays(Asked::Shadow),
            Use::Collision => Source::Steps,
            Use::Visibility => Source::Sights,
            Use::Radiosity => Source::Patches,
        }
    }
}

impl Source {
    /// The word for it.
    pub fn word(&self) -> &str {
        match self {
            Source::Rays(asked) => asked.word(),
            Source::Steps => "steps",
            Source::Sights => "sights",
            Source::Patches => "patches",
        }
    }
}

/// What is needed of the answers, and by whom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// What a hit has to tell.
    pub output: Output,
    /// For what, if that was said.
    pub usage: Option<Use>,
    /// The rays.
    pub source: Source,
}

impl Wanted {
    /// What was asked for; what was not follows from the use, or is that of a picture.
    pub fn of(output: Option<Output>, usage: Option<Use>, rays: Option<Asked>) -> Self {
        let preset = usage.unwrap_or(Use::Raytracing);
        let shadow = usage.is_none() && rays == Some(Asked::Shadow);
        let usual = if shadow { Output::Hit } else { preset.needs() };
        Wanted {
            output: output.unwrap_or(usual),
            usage,
            source: rays.map_or_else(|| preset.source(), Source::Rays),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_asked_for_outranks_the_use() {
        let plain = Wanted::of(None, None, None);
        assert_eq!(plain.output, Output::Tuv);
        assert_eq!(plain.source, Source::Rays(Asked::Primary));
        // Shadow rays ask for no more than whether there is a hit, unless more is asked for.
        assert_eq!(Wanted::of(None, None, Some(Asked::Shadow)).output, Output::Hit);
        let shadow = Wanted::of(Some(Output::T), Some(Use::Shadow), Some(Asked::Random));
        assert_eq!((shadow.output, shadow.source), (Output::T, Source::Rays(Asked::Random)));
        let radiosity = Wanted::of(None, Some(Use::Radiosity), None);
        assert_eq!((radiosity.output, radiosity.source), (Output::Hit, Source::Patches));
    }
}
