//! A word of the command line for each value of a type of the library.

/// The library's words, for clap.
macro_rules! words {
    ($(#[$doc:meta])* $name:ident for $target:ty { $($value:ident => $of:expr,)* }) => {
        $(#[$doc])*
        #[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs, reason = "the words explain themselves where they are used")]
        pub enum $name { $($value,)* }
        impl $name {
            /// The library's own type.
            pub fn value(self) -> $target {
                match self { $($name::$value => $of,)* }
            }
        }
    };
}

pub(super) use words;
