//! Lists of numbers that JavaScript gets as typed arrays: copies of its own, safe to transfer
//! between threads. Natively they are plain lists.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::ops::{Deref, DerefMut};

/// A list of numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TypedArray<T>(pub Vec<T>);

impl<T> Deref for TypedArray<T> {
    type Target = Vec<T>;

    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T> DerefMut for TypedArray<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.0
    }
}

impl<T> From<Vec<T>> for TypedArray<T> {
    fn from(values: Vec<T>) -> Self {
        Self(values)
    }
}

impl<T> FromIterator<T> for TypedArray<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        Self(values.into_iter().collect())
    }
}

impl<T> PartialEq<Vec<T>> for TypedArray<T>
where
    T: PartialEq,
{
    fn eq(&self, other: &Vec<T>) -> bool {
        self.0 == *other
    }
}

macro_rules! typed_array {
    ($number:ty, $array:ident) => {
        impl Serialize for TypedArray<$number> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                #[cfg(target_arch = "wasm32")]
                return serde_wasm_bindgen::preserve::serialize(
                    &js_sys::$array::from(self.0.as_slice()),
                    serializer,
                );
                #[cfg(not(target_arch = "wasm32"))]
                self.0.serialize(serializer)
            }
        }

        impl<'de> Deserialize<'de> for TypedArray<$number> {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                #[cfg(target_arch = "wasm32")]
                return serde_wasm_bindgen::preserve::deserialize::<D, js_sys::$array>(
                    deserializer,
                )
                .map(|array| Self(array.to_vec()));
                #[cfg(not(target_arch = "wasm32"))]
                Vec::deserialize(deserializer).map(Self)
            }
        }

        #[cfg(test)]
        impl ts_rs::TS for TypedArray<$number> {
            type WithoutGenerics = Self;
            type OptionInnerType = Self;

            fn name(_: &ts_rs::Config) -> String {
                concat!(stringify!($array), "<ArrayBuffer>").into()
            }

            fn inline(config: &ts_rs::Config) -> String {
                Self::name(config)
            }
        }
    };
}

typed_array!(u8, Uint8Array);
typed_array!(u32, Uint32Array);
typed_array!(f32, Float32Array);
typed_array!(f64, Float64Array);
