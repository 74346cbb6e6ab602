//! One process-wide store of quadrature rules, so that each is computed once.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use crate::contact::Result;

/// What a stored rule depends on besides its number type and precision.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) enum Key {
    /// All levels of the double exponential rule.
    TanhSinh,
    /// The Gauss rule with `n` nodes; the exponents as text, which tells all arithmetics apart.
    GaussJacobi { n: usize, alpha: String, beta: String },
}

/// A rule together with a rough count of the bits in it.
pub(super) trait Stored: Any + Send + Sync {
    fn bits(&self) -> usize;
}

#[derive(Default)]
struct Store {
    rules: HashMap<(TypeId, u32, Key), Arc<dyn Any + Send + Sync>>,
    bits: usize,
}

/// When the store holds more than this many bits (128 MB) it is emptied; rules in use stay alive with their users.
const CAPACITY: usize = 1 << 30;

static STORE: LazyLock<Mutex<Store>> = LazyLock::new(Mutex::default);

/// The stored rule, or the one that `build` makes. Building happens outside the lock: at worst two threads build twice.
pub(super) fn rule<V: Stored>(precision: u32, key: Key, build: impl FnOnce() -> Result<V>) -> Result<Arc<V>> {
    let key = (TypeId::of::<V>(), precision, key);
    let found = STORE.lock().unwrap_or_else(PoisonError::into_inner).rules.get(&key).cloned();
    if let Some(rule) = found.and_then(|any| any.downcast::<V>().ok()) {
        return Ok(rule);
    }
    let rule = Arc::new(build()?);
    let mut store = STORE.lock().unwrap_or_else(PoisonError::into_inner);
    if store.bits > CAPACITY {
        *store = Store::default();
    }
    store.bits += rule.bits();
    store.rules.insert(key, rule.clone());
    Ok(rule)
}
