//! One list of columns makes the row, its header and its access by name.

/// Declares [`Row`], its header and its access by column name from one list, so that the order in
/// the file, the names and the fields cannot drift apart. A number below 0 is read in no column but
/// those that stand there with `[signed]`.
macro_rules! columns {
    (@bound) => { Bound::NotNegative };
    (@bound signed) => { Bound::None };
    ([] { $($(#[$doc:meta])* $name:ident: $kind:ty $([$signed:ident])?,)* }) => {
        /// One line of `rows.csv`. An empty string and `None` are missing values.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct Row { $($(#[$doc])* pub $name: $kind,)* }

        /// Every column, in the order of the file.
        pub const COLUMNS: &[&str] = &[$(stringify!($name)),*];

        impl Row {
            /// The value in a column; `None` if there is no such column.
            pub fn cell(&self, column: &str) -> Option<Cell<'_>> {
                match column {
                    $(stringify!($name) => Some(self.$name.cell()),)*
                    _ => None,
                }
            }

            /// Puts a value into a column from its text; the error says what is allowed there.
            /// A column that this version does not know is ignored: a later version may.
            pub fn set(&mut self, column: &str, text: &str) -> Result<(), &'static str> {
                match column {
                    $(stringify!($name) => {
                        self.$name = Field::parse(text, columns!(@bound $($signed)?))?;
                    })*
                    _ => {}
                }
                Ok(())
            }
        }
    };
}

pub(super) use columns;
