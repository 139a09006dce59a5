//! A reader of classic netCDF (CDF-1, "The NetCDF Classic Format Specification"), enough for the tests.

use std::collections::BTreeMap;

pub struct Variable {
    pub dimensions: Vec<String>,
    pub attributes: BTreeMap<String, String>,
    /// Numbers, or letters as their codes.
    pub values: Vec<f64>,
}

pub struct Data {
    pub dimensions: BTreeMap<String, usize>,
    pub variables: BTreeMap<String, Variable>,
}

struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Cursor<'_> {
    fn int(&mut self) -> usize {
        self.at += 4;
        u32::from_be_bytes(self.bytes[self.at - 4..self.at].try_into().unwrap()) as usize
    }

    /// Bytes padded to a multiple of four.
    fn padded(&mut self, count: usize) -> Vec<u8> {
        let start = self.at;
        self.at += count.next_multiple_of(4);
        self.bytes[start..start + count].to_vec()
    }

    fn name(&mut self) -> String {
        let count = self.int();
        String::from_utf8(self.padded(count)).unwrap()
    }

    /// The number of entries of a list, whose tag may be absent.
    fn list(&mut self) -> usize {
        self.int();
        self.int()
    }

    fn attributes(&mut self) -> BTreeMap<String, String> {
        let count = self.list();
        let attribute = |cursor: &mut Self| {
            let (name, kind, count) = (cursor.name(), cursor.int(), cursor.int());
            (name, String::from_utf8_lossy(&cursor.padded(count * size(kind))).into_owned())
        };
        (0..count).map(|_| attribute(self)).collect()
    }
}

fn size(kind: usize) -> usize {
    [0, 1, 1, 2, 4, 4, 8][kind]
}

fn number(kind: usize, bytes: &[u8]) -> f64 {
    match kind {
        2 => f64::from(bytes[0]),
        4 => f64::from(i32::from_be_bytes(bytes.try_into().unwrap())),
        6 => f64::from_be_bytes(bytes.try_into().unwrap()),
        other => panic!("type {other}"),
    }
}

pub fn read(bytes: &[u8]) -> Data {
    assert_eq!(&bytes[..4], b"CDF\x01");
    let mut cursor = Cursor { bytes, at: 8 };
    let count = cursor.list();
    let dimensions: Vec<(String, usize)> = (0..count).map(|_| (cursor.name(), cursor.int())).collect();
    cursor.attributes();
    let count = cursor.list();
    let variables = (0..count).map(|_| variable(&mut cursor, &dimensions)).collect();
    Data { dimensions: dimensions.into_iter().collect(), variables }
}

fn variable(cursor: &mut Cursor<'_>, dimensions: &[(String, usize)]) -> (String, Variable) {
    let (name, rank) = (cursor.name(), cursor.int());
    let shape: Vec<&(String, usize)> = (0..rank).map(|_| &dimensions[cursor.int()]).collect();
    let attributes = cursor.attributes();
    let (kind, _, begin) = (cursor.int(), cursor.int(), cursor.int());
    let count: usize = shape.iter().map(|dimension| dimension.1).product();
    let data = &cursor.bytes[begin..begin + count * size(kind)];
    let values = data.chunks(size(kind)).map(|bytes| number(kind, bytes)).collect();
    (name, Variable { dimensions: shape.iter().map(|d| d.0.clone()).collect(), attributes, values })
}
