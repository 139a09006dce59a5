//! A ZIP archive of stored (uncompressed) files, as in PKWARE's APPNOTE 6.3: local headers, central directory, end
//! record. Times are 1980-01-01, so that equal contents give equal bytes. For less than 4 GiB and 65536 files.

/// The archive of `files`, name and contents.
pub(super) fn stored(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    let (mut archive, mut directory) = (Vec::new(), Vec::new());
    for (name, contents) in files {
        let offset = archive.len() as u32;
        let entry = entry(name, contents);
        archive.extend(b"PK\x03\x04");
        archive.extend(&entry);
        archive.extend(name.as_bytes());
        archive.extend(contents);
        directory.extend(b"PK\x01\x02\x14\x00");
        directory.extend(entry);
        // No comment, disk 0, no attributes.
        directory.extend([0; 10]);
        directory.extend(offset.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let (at, size, count) = (archive.len() as u32, directory.len() as u32, files.len() as u16);
    archive.extend(directory);
    archive.extend(b"PK\x05\x06\x00\x00\x00\x00");
    archive.extend([count.to_le_bytes(), count.to_le_bytes()].concat());
    archive.extend([size.to_le_bytes(), at.to_le_bytes()].concat());
    archive.extend([0; 2]);
    archive
}

/// What local header and directory share: version 2.0, no flags, stored, midnight of 1980-01-01, checksum, sizes, no
/// extra field.
fn entry(name: &str, contents: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0x14, 0, 0, 0, 0, 0, 0, 0, 0x21, 0];
    bytes.extend(crc32(contents).to_le_bytes());
    let size = (contents.len() as u32).to_le_bytes();
    bytes.extend([size, size].concat());
    bytes.extend((name.len() as u16).to_le_bytes());
    bytes.extend([0; 2]);
    bytes
}

/// The cyclic redundancy check of ISO 3309, polynomial 0xEDB88320 reflected.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The check value of every catalogue of such codes.
    #[test]
    fn the_checksum_of_the_nine_digits() {
        assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
    }
}
