//! All power laws in one family.

use super::{ABOVE, BELOW, BOTH, Entry, Step};

pub(super) const CURVES: Entry = Entry {
    id: "universal-curves",
    title: "Universal curves",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 0`, $n \\ne \\tfrac12$", "`t = a/a_c`"],
    steps: &[
        Step::proved(
            ABOVE,
            "at(d_n, a, t*a_c) = -d_c*(t^n - 2*n*t^(1/2))/(2*n - 1)",
            "The indentation in units of $|d_c| = -d_c$ depends on `n` and `t` only.",
        ),
        Step::proved(
            BELOW,
            "at(d_n, a, t*a_c) = d_c*(t^n - 2*n*t^(1/2))/(1 - 2*n)",
            "The same below `n = 1/2`, where $|d_c| = d_c$.",
        ),
        Step::proved(
            BOTH,
            "at(F_n, a, t*a_c) = -F_c*(t^(n + 1) - 2*(n + 1)*t^(3/2))/(2*n + 1)",
            "The force in units of $|F_c| = -F_c$. `E`, `w` and `C` are gone: `n` is the only parameter.",
        ),
    ],
    erratum: None,
    references: &[],
};
