//! A method as a card and a function that prepares it.

use crate::{Card, Cloud, Method, MethodError, Ready};

type Prepare = dyn Fn(&Card, &Cloud) -> Result<Box<dyn Ready>, MethodError> + Send + Sync;

/// What all methods of this crate are.
pub(crate) struct Simple {
    card: Card,
    prepare: Box<Prepare>,
}

impl Simple {
    pub(crate) fn new(
        card: Card,
        prepare: impl Fn(&Card, &Cloud) -> Result<Box<dyn Ready>, MethodError> + Send + Sync + 'static,
    ) -> Self {
        Self { card, prepare: Box::new(prepare) }
    }
}

impl Method for Simple {
    fn card(&self) -> &Card {
        &self.card
    }

    fn prepare(&self, cloud: &Cloud) -> Result<Box<dyn Ready>, MethodError> {
        self.card.domain.check_cloud(cloud)?;
        (self.prepare)(&self.card, cloud)
    }
}
