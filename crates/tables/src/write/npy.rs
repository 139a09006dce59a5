//! NumPy's array file, version 1.0 (NEP 1): magic, a Python dictionary padded to 64 bytes, the numbers.

/// A `.npy` of little-endian f64 in C order.
pub(super) fn doubles(shape: &[usize], values: &[f64]) -> Vec<u8> {
    let bytes = values.iter().flat_map(|value| value.to_le_bytes());
    array("<f8", shape, bytes.collect())
}

/// A `.npy` of strings, UTF-32 padded with zeros to the longest.
pub(super) fn strings(values: &[String]) -> Vec<u8> {
    let longest = values.iter().map(|value| value.chars().count()).max().unwrap_or(0).max(1);
    let padded = values.iter().flat_map(|value| {
        let characters = value.chars().map(u32::from).chain(std::iter::repeat(0));
        characters.take(longest).flat_map(u32::to_le_bytes)
    });
    array(&format!("<U{longest}"), &[values.len()], padded.collect())
}

/// A `.npy` of one string.
pub(super) fn string(value: &str) -> Vec<u8> {
    let bytes = value.chars().flat_map(|character| u32::from(character).to_le_bytes());
    array(&format!("<U{}", value.chars().count().max(1)), &[], bytes.collect())
}

fn array(kind: &str, shape: &[usize], data: Vec<u8>) -> Vec<u8> {
    let sizes: String = shape.iter().map(|size| format!("{size},")).collect();
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({sizes}), }}");
    const BEFORE: usize = 10;
    let padding = 63 - (BEFORE + header.len()) % 64;
    header.push_str(&" ".repeat(padding));
    header.push('\n');
    let mut file = b"\x93NUMPY\x01\x00".to_vec();
    file.extend((header.len() as u16).to_le_bytes());
    file.extend(header.as_bytes());
    file.extend(data);
    file
}
