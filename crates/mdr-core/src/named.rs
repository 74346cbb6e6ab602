//! Enums whose members have names.

/// Declares an enum whose members have names, which are also how they are displayed.
///
/// ```
/// mdr_core::named! {
///     /// How often.
///     pub enum Times {
///         /// Once.
///         Once = "once",
///         /// Twice.
///         Twice = "twice",
///     }
/// }
/// assert_eq!(Times::ALL.map(Times::name), ["once", "twice"]);
/// assert_eq!(Times::Twice.to_string(), "twice");
/// ```
#[macro_export]
macro_rules! named {
    ($(#[$meta:meta])* $visible:vis enum $type:ident { $($(#[$doc:meta])* $member:ident = $name:literal,)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $visible enum $type {$(
            $(#[$doc])*
            $member,
        )*}

        impl $type {
            /// All of them.
            $visible const ALL: [$type; [$($name),*].len()] = [$($type::$member),*];

            /// The name in scenes and answers.
            $visible const fn name(self) -> &'static str {
                match self {
                    $($type::$member => $name,)*
                }
            }
        }

        impl ::std::fmt::Display for $type {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                f.write_str(self.name())
            }
        }
    };
}
