//! A value that arrives once, from a callback.
//!
//! wgpu's callbacks must be `Send`, JavaScript handles are not; this carries the value
//! from the one to the future that holds the other.

use std::future::poll_fn;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Poll, Waker};

/// A cell that is set at most once; clones share it. One future may wait for it.
#[derive(Debug)]
pub struct Signal<T>(Arc<Mutex<(Option<T>, Option<Waker>)>>);

impl<T> Clone for Signal<T> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<T> Default for Signal<T> {
    fn default() -> Self {
        Self(Arc::default())
    }
}

impl<T: Clone> Signal<T> {
    /// Gives the value; later ones are dropped.
    pub fn set(&self, value: T) {
        let mut cell = self.lock();
        cell.0.get_or_insert(value);
        let waker = cell.1.take();
        drop(cell);
        if let Some(waker) = waker {
            waker.wake();
        }
    }

    /// The value, if it has arrived.
    pub fn get(&self) -> Option<T> {
        self.lock().0.clone()
    }

    /// The value, once it arrives.
    pub async fn wait(&self) -> T {
        poll_fn(|context| {
            let mut cell = self.lock();
            if let Some(value) = &cell.0 {
                return Poll::Ready(value.clone());
            }
            cell.1 = Some(context.waker().clone());
            Poll::Pending
        })
        .await
    }

    fn lock(&self) -> MutexGuard<'_, (Option<T>, Option<Waker>)> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
