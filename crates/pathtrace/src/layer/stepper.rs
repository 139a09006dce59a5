//! The squares of a grid that a line crosses, one after the other (Amanatides & Woo 1987).

/// One square of the grid and where the line enters it.
pub(super) struct Stepper {
    pub(super) cell: [i64; 2],
    /// Distance at which the line enters it.
    pub(super) start: f64,
    /// Distance at which the next line of the grid is crossed along each axis, and between two such.
    next: [f64; 2],
    each: [f64; 2],
    way: [i64; 2],
}

impl Stepper {
    /// Of the squares of side 1/`scale` that the line from `line[axis][0]` at speed `line[axis][1]` crosses from distance `from` on.
    pub(super) fn new(line: [[f64; 2]; 2], scale: f64, from: f64) -> Self {
        let mut stepper = Self {
            cell: [0; 2],
            start: from,
            next: [f64::INFINITY; 2],
            each: [f64::INFINITY; 2],
            way: [0; 2],
        };
        for (axis, way) in line.into_iter().enumerate() {
            let [origin, speed] = way.map(|x| x * scale);
            stepper.cell[axis] = super::floor(origin + speed * from);
            if speed != 0.0 {
                let slowness = 1.0 / speed;
                let edge = (stepper.cell[axis] + i64::from(speed > 0.0)) as f64;
                stepper.next[axis] = ((edge - origin) * slowness).max(from);
                stepper.each[axis] = slowness.abs();
                stepper.way[axis] = if speed > 0.0 { 1 } else { -1 };
            }
        }
        stepper
    }

    /// The same, started no further out than the squares from `first` to `last`: what rounding puts there.
    pub(super) fn within(mut self, first: [i64; 2], last: [i64; 2]) -> Self {
        for axis in 0..2 {
            let cell = self.cell[axis].clamp(first[axis], last[axis]);
            let off = (cell - self.cell[axis]) * self.way[axis];
            if off > 0 {
                self.next[axis] += off as f64 * self.each[axis];
            }
            self.cell[axis] = cell;
        }
        self
    }

    /// Distance at which the line leaves the square.
    #[inline]
    pub(super) fn end(&self) -> f64 {
        self.next[0].min(self.next[1])
    }

    /// To the next square.
    #[inline]
    pub(super) fn step(&mut self) {
        let axis = usize::from(self.next[1] < self.next[0]);
        self.start = self.next[axis];
        self.cell[axis] += self.way[axis];
        self.next[axis] += self.each[axis];
    }
}
