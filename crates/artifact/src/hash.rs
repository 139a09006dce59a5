//! Hashes that name inputs: BLAKE3, cut to 128 bits and written as hexadecimal.

use serde::Serialize;

/// Hash of raw bytes.
pub fn hash_bytes(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex()[..32].to_owned()
}

/// Hash of a value through its JSON form.
///
/// # Panics
/// Never for types whose serialisation cannot fail, which all of this project's are.
pub fn hash_of<T: Serialize + ?Sized>(value: &T) -> String {
    hash_bytes(serde_json::to_string(value).expect("plain data serialises").as_bytes())
}
