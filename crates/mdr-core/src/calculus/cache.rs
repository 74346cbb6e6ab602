//! One process-wide store of quadrature rules, so that each is computed once.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, PoisonError};

use crate::contact::Result;

/// The key of a stored rule, beside its number type and precision.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) enum Key {
    /// All levels of the double exponential rule.
    TanhSinh,
    /// The Gauss rule with `n` nodes. The exponents are kept as text, which is distinct in every arithmetic.
    GaussJacobi { n: usize, alpha: String, beta: String },
    /// The Gauss–Legendre rule with `n` nodes, as enclosures.
    #[cfg(feature = "mp")]
    Legendre { n: usize },
}

/// A rule that can report roughly how many bits it occupies when it is built.
pub(super) trait Stored: Any + Send + Sync {
    fn bits(&self) -> usize;
}

/// Rules by number type, precision and key.
#[derive(Default)]
pub(super) struct Cache(Mutex<Store>);

#[derive(Default)]
struct Store {
    rules: HashMap<(TypeId, u32, Key), Arc<dyn Any + Send + Sync>>,
    bits: usize,
}

impl Store {
    /// Adds `bits` to the count and empties a store that was already full.
    fn count(&mut self, bits: usize) {
        if self.bits > CAPACITY {
            *self = Store::default();
        }
        self.bits += bits;
    }
}

/// A cache with more than this many bits (128 MB) is emptied; rules in use stay alive with their users.
const CAPACITY: usize = 1 << 30;

/// The cache of the process.
pub(super) static RULES: LazyLock<Cache> = LazyLock::new(Cache::default);

impl Cache {
    fn store(&self) -> MutexGuard<'_, Store> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The stored rule, or the one that `build` makes. Building happens outside the lock: at worst two threads build
    /// twice.
    pub(super) fn rule<V: Stored>(
        &self,
        precision: u32,
        key: Key,
        build: impl FnOnce() -> Result<V>,
    ) -> Result<Arc<V>> {
        let key = (TypeId::of::<V>(), precision, key);
        let found = self.store().rules.get(&key).cloned();
        if let Some(rule) = found.and_then(|any| any.downcast::<V>().ok()) {
            return Ok(rule);
        }
        let rule = Arc::new(build()?);
        let mut store = self.store();
        store.count(rule.bits());
        store.rules.insert(key, rule.clone());
        Ok(rule)
    }

    /// Counts the bits by which a rule has grown since it was built, including rules that are no longer stored.
    pub(super) fn grown(&self, bits: usize) {
        self.store().count(bits);
    }

    /// The bits in the store.
    #[cfg(test)]
    pub(super) fn bits(&self) -> usize {
        self.store().bits
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Rule(usize);

    impl Stored for Rule {
        fn bits(&self) -> usize {
            self.0
        }
    }

    #[test]
    fn a_full_cache_is_emptied_whether_by_new_rules_or_by_those_that_grow() {
        let cache = Cache::default();
        let mut built = 0;
        let mut ask = |precision, bits| {
            let rule = cache.rule(precision, Key::TanhSinh, || {
                built += 1;
                Ok(Rule(bits))
            });
            (rule.unwrap(), built)
        };
        let (in_use, _) = ask(1, 7);
        assert_eq!((ask(1, 7).1, cache.bits()), (1, 7));
        cache.grown(CAPACITY);
        // Full, but nothing is added.
        assert_eq!((ask(1, 7).1, cache.bits()), (1, CAPACITY + 7));
        cache.grown(5);
        assert_eq!((in_use.0, cache.bits()), (7, 5));
        // Rebuilt here; the next rule empties the cache again.
        assert_eq!((ask(1, CAPACITY).1, cache.bits()), (2, CAPACITY + 5));
        assert_eq!((ask(2, 3).1, cache.bits()), (3, 3));
        assert_eq!((ask(1, 4).1, cache.bits()), (4, 7));
    }
}
