//! Enums whose members have names.

/// Declares an enum whose members have names, which are also how they are displayed.
macro_rules! named {
    ($(#[$meta:meta])* $visible:vis enum $type:ident { $($(#[$doc:meta])* $member:ident = $name:literal,)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        $visible enum $type {$(
            $(#[$doc])*
            $member,
        )*}

        impl $type {
            /// All of them.
            $visible const ALL: [$type; [$($name),*].len()] = [$($type::$member),*];

            /// The name in records and reports.
            $visible const fn name(self) -> &'static str {
                match self {
                    $($type::$member => $name,)*
                }
            }
        }

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }
    };
}

pub(crate) use named;
