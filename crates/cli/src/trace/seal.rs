//! A file of one line of JSON, a binary body and a checksum: `stratiform/trace-part/1`.
//!
//! The line (`head -1` shows it) has schema, program version, length of the body, and what the caller says of it; then
//! come the body and the 32 bytes of BLAKE3 of all before them. Whole numbers that count are in the body: JSON
//! readers elsewhere lose digits beyond 2⁵³. Damage is told from a file of another kind and from a short one.

use serde::{Deserialize, Serialize, de::DeserializeOwned};
use stratiform_artifact::Provenance;

/// The schema's name and version.
pub const SCHEMA: &str = "stratiform/trace-part/1";
const CHECKSUM: usize = blake3::OUT_LEN;

#[derive(Serialize, Deserialize)]
struct Header<T> {
    schema: String,
    version: String,
    bytes: u64,
    about: T,
}

/// As much of a header as any file of this program has.
#[derive(Deserialize)]
struct Kind {
    schema: String,
}

/// `body` with what is to be known `about` it.
///
/// # Errors
/// A message if `about` cannot be written.
pub fn seal<T: Serialize>(about: &T, body: &[u8]) -> Result<Vec<u8>, String> {
    let (schema, version) = (SCHEMA.to_owned(), version());
    let header = Header { schema, version, bytes: body.len() as u64, about };
    let mut bytes = serde_json::to_vec(&header).map_err(|error| error.to_string())?;
    bytes.push(b'\n');
    bytes.extend_from_slice(body);
    let checksum = blake3::hash(&bytes);
    bytes.extend_from_slice(checksum.as_bytes());
    Ok(bytes)
}

/// What [`seal`] was given.
///
/// # Errors
/// A message that says whether the bytes are of another kind, cut short, damaged, or of another program version.
pub fn open<T: DeserializeOwned>(bytes: &[u8]) -> Result<(T, &[u8]), String> {
    let other = || "it is no part of a trace, or its first line is damaged".to_owned();
    let end = bytes.iter().position(|byte| *byte == b'\n').ok_or_else(other)?;
    let line = &bytes[..end];
    let kind: Kind = serde_json::from_slice(line).map_err(|_| other())?;
    if kind.schema != SCHEMA {
        return Err(format!("its schema is {}, not {SCHEMA}", kind.schema));
    }
    let header: Header<serde_json::Value> = serde_json::from_slice(line).map_err(|_| other())?;
    let body = checked(bytes, end + 1, header.bytes)?;
    if header.version != version() {
        return Err(format!(
            "it was written by version {} of stratiform, this is {}",
            header.version,
            version()
        ));
    }
    let about = serde_json::from_value(header.about).map_err(|error| error.to_string())?;
    Ok((about, body))
}

/// The body of `length` bytes from `start` on, if the checksum after it fits.
fn checked(bytes: &[u8], start: usize, length: u64) -> Result<&[u8], String> {
    let (found, wanted) = (bytes.len() as u64, (start + CHECKSUM) as u64);
    let wanted = wanted.saturating_add(length);
    if found != wanted {
        let fault = if found < wanted { "cut short" } else { "damaged" };
        return Err(format!("it is {fault}: {found} bytes, not {wanted}"));
    }
    let (content, checksum) = bytes.split_at(bytes.len() - CHECKSUM);
    if blake3::hash(content).as_bytes() != checksum {
        return Err("it is damaged: its checksum does not fit".to_owned());
    }
    Ok(&content[start..])
}

fn version() -> String {
    Provenance::new(String::new(), None, "").version
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every bit of every byte, and every length.
    #[test]
    fn whatever_is_changed_is_refused() {
        let good = seal(&"about", &[0, 1, 200, 255]).unwrap();
        assert_eq!(open::<String>(&good), Ok(("about".to_owned(), &[0, 1, 200, 255][..])));
        for at in 0..good.len() {
            for bit in 0..8 {
                let mut bytes = good.clone();
                bytes[at] ^= 1 << bit;
                assert!(open::<String>(&bytes).is_err(), "bit {bit} of byte {at}");
            }
            let cut = open::<String>(&good[..at]).unwrap_err();
            assert!(cut.contains("cut short") || cut.contains("no part"), "{cut}");
        }
        let longer = [&good[..], b"x"].concat();
        assert!(open::<String>(&longer).unwrap_err().contains("damaged"));
    }

    #[test]
    fn other_kinds_and_versions_are_named() {
        let error = |text: &str| open::<String>(text.as_bytes()).unwrap_err();
        assert!(error("").contains("no part of a trace"));
        assert!(error("tau,mu0\n1,1\n").contains("no part of a trace"));
        assert!(error("{\"schema\":\"stratiform/trace-part/2\"}\n").contains("trace-part/2, not"));
        let mut old =
            format!("{{\"schema\":\"{SCHEMA}\",\"version\":\"0.0.1\",\"bytes\":0,\"about\":\"\"}}\n");
        let checksum = blake3::hash(old.as_bytes());
        let mut bytes = std::mem::take(&mut old).into_bytes();
        bytes.extend_from_slice(checksum.as_bytes());
        assert!(open::<String>(&bytes).unwrap_err().contains("version 0.0.1 of stratiform"));
    }
}
