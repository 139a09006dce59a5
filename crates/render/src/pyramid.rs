//! Where the pyramid of greatest thicknesses lies in the buffer of the height field.

use crate::view::LEVELS;

/// A level: its first number in the buffer, and its texels a side.
pub type Level = [u32; 2];

/// The levels behind the thicknesses, from single cells up to the whole field.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels(Vec<Level>);

impl Levels {
    /// Of a field of `side` texels a side, 1 to 8192.
    pub fn new(side: u32) -> Self {
        let mut levels = vec![[side * side, side]];
        while let Some(&[start, side]) = levels.last()
            && side > 1
        {
            levels.push([start + side * side, side.div_ceil(2)]);
        }
        Self(levels)
    }

    /// The coarsest.
    pub fn top(&self) -> u32 {
        self.0.len() as u32 - 1
    }

    /// Numbers in the buffer, thicknesses included.
    pub fn numbers(&self) -> usize {
        self.0.last().map_or(0, |[start, side]| (start + side * side) as usize)
    }

    /// What each level is made from, and the level.
    pub fn steps(&self) -> impl Iterator<Item = (Level, Level)> {
        let field = [0, self.0[0][1]];
        std::iter::once(field).chain(self.0.iter().copied()).zip(self.0.iter().copied())
    }

    /// For the passes.
    pub fn table(&self) -> [[u32; 4]; LEVELS] {
        std::array::from_fn(|i| self.0.get(i).map_or([0; 4], |[start, side]| [*start, *side, 0, 0]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_halve_down_to_one_texel() {
        let levels = Levels::new(5);
        let sides: Vec<u32> = levels.steps().map(|(_, [_, side])| side).collect();
        assert_eq!((sides, levels.top(), levels.numbers()), (vec![5, 3, 2, 1], 3, 25 + 25 + 9 + 4 + 1));
        assert_eq!((Levels::new(1).top(), Levels::new(1).numbers()), (0, 2));
        assert!(Levels::new(8192).top() < LEVELS as u32);
    }
}
