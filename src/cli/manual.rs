//! `ray_test completions` and `ray_test man`: what shells and `man` know of the command line.

use std::io::Write;

use clap::{Args, Command, CommandFactory};
use clap_complete::{Shell, generate};
use clap_mangen::Man;

use super::arguments::Arguments;
use super::failure::Failure;

/// Text under `ray_test completions --help`.
pub const COMPLETIONS_HELP: &str = "\
Examples:
  ray_test completions bash > ~/.local/share/bash-completion/completions/ray_test
  ray_test completions zsh > ~/.zfunc/_ray_test       (a folder in fpath)
  ray_test completions fish > ~/.config/fish/completions/ray_test.fish";

/// Text under `ray_test man --help`.
pub const MAN_HELP: &str = "\
Examples:
  ray_test man > ~/.local/share/man/man1/ray_test.1
  ray_test man scene > ~/.local/share/man/man1/ray_test-scene.1";

/// `ray_test completions`
#[derive(Args, Debug)]
pub struct Completions {
    /// What completes: it is asked to complete `ray_test`
    #[arg(value_enum)]
    pub shell: Shell,
}

/// `ray_test man`
#[derive(Args, Debug)]
pub struct Manual {
    /// A verb, for its own page; without one the page of the whole
    pub verb: Option<String>,
}

/// Prints the script that completes for a shell.
///
/// # Errors
/// When stdout cannot be written.
pub fn completions(asked: &Completions) -> Result<(), Failure> {
    print(&script(asked.shell))
}

/// Prints a page for `man`, as roff.
///
/// # Errors
/// A verb that there is not; when stdout cannot be written.
pub fn man(asked: &Manual) -> Result<(), Failure> {
    print(&page(asked.verb.as_deref())?)
}

fn print(text: &[u8]) -> Result<(), Failure> {
    // The generators take no failure to write: a closed pipe must not meet them.
    Ok(std::io::stdout().lock().write_all(text)?)
}

fn script(shell: Shell) -> Vec<u8> {
    let mut text = Vec::new();
    generate(shell, &mut Arguments::command(), "ray_test", &mut text);
    text
}

/// The page of a verb, or of the whole.
///
/// # Errors
/// A verb that there is not.
pub fn page(verb: Option<&str>) -> Result<Vec<u8>, Failure> {
    let mut command = Arguments::command();
    command.build();
    let of = match verb {
        None => command,
        Some(verb) => command.find_subcommand(verb).cloned().ok_or_else(|| unknown(verb))?,
    };
    let mut text = Vec::new();
    Man::new(of).render(&mut text)?;
    Ok(text)
}

fn unknown(verb: &str) -> Failure {
    Failure::Usage(format!("'{verb}' is no verb; allowed: {}", verbs().join(", ")))
}

/// Every verb that help shows.
fn verbs() -> Vec<String> {
    let command = Arguments::command();
    let shown = command.get_subcommands().filter(|verb| !verb.is_hide_set());
    shown.map(Command::get_name).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::ValueEnum;

    fn text(bytes: Vec<u8>) -> String {
        String::from_utf8(bytes).expect("text")
    }

    #[test]
    fn every_shell_has_a_script_that_names_every_verb() {
        assert!(verbs().len() > 10 && verbs().contains(&"completions".to_owned()));
        for shell in Shell::value_variants() {
            let script = text(script(*shell));
            for verb in verbs() {
                assert!(script.contains(&verb), "{shell}: {verb}");
            }
            assert!(script.contains("--rays-per-triangle") || script.contains("rays-per-triangle"));
        }
        let starts = |shell, start: &str| text(script(shell)).starts_with(start);
        assert!(starts(Shell::Bash, "_ray_test()") && starts(Shell::Zsh, "#compdef ray_test"));
    }

    #[test]
    fn the_manual_names_every_verb_and_each_has_a_page() {
        let whole = text(page(None).expect("the whole"));
        assert!(whole.contains(".TH ray_test 1"), "{}", &whole[..200]);
        for verb in verbs() {
            // Hyphens are escaped in roff.
            let name = format!("ray_test\\-{verb}(1)").replace("ray_test", "ray_test");
            assert!(whole.contains(&name), "{name} in {whole}");
            let own = text(page(Some(&verb)).expect(&verb));
            assert!(own.contains(&format!(".TH ray_test-{verb} 1")), "{}", &own[..200]);
            assert!(own.contains("\\-\\-help"), "{verb}");
        }
    }

    #[test]
    fn a_page_of_nothing_is_refused_by_name() {
        let Err(Failure::Usage(message)) = page(Some("scenes")) else { panic!("it was taken") };
        assert!(message.contains("'scenes'") && message.contains("scene, "), "{message}");
    }
}
