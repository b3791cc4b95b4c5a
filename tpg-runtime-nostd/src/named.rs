//! Enumerations whose values have names in files.

/// Defines an enumeration with the name of each value.
///
/// ```
/// tpg_runtime::named! {
///     /// A side.
///     #[derive(Debug, Clone, Copy, PartialEq)]
///     pub enum Side {
///         /// The left one.
///         Left = "left",
///         /// The right one.
///         Right = "right",
///     }
/// }
///
/// assert_eq!((Side::ALL[1].name(), Side::from_name("left")), ("right", Some(Side::Left)));
/// ```
#[macro_export]
macro_rules! named {
    ($(#[$about:meta])* pub enum $type:ident { $($(#[$doc:meta])* $value:ident = $name:literal,)+ }) => {
        $(#[$about])*
        pub enum $type {
            $($(#[$doc])* $value,)+
        }

        impl $type {
            /// Every value, in the order of the enumeration.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$value),+];

            /// Returns the name in files.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$value => $name,)+
                }
            }

            /// Finds the value of that [`name`](Self::name).
            pub const fn from_name(name: &str) -> Option<Self> {
                let mut place = 0;
                while place < Self::ALL.len() {
                    if $crate::named::same(Self::ALL[place].name().as_bytes(), name.as_bytes()) {
                        return Some(Self::ALL[place]);
                    }
                    place += 1;
                }
                None
            }
        }
    };
}

/// Returns true if both are the same bytes: `==` for constants.
pub const fn same(a: &[u8], b: &[u8]) -> bool {
    match (a.split_first(), b.split_first()) {
        (Some((first, rest)), Some((other, others))) => *first == *other && same(rest, others),
        (None, None) => true,
        _ => false,
    }
}
