//! Environments that wrap another one.

/// Forwards methods of [`Environment<S>`](crate::Environment) to the environment inside.
///
/// `forward!(this => this.inner; draw time_limit)` within `impl<S: Scalar, …> Environment<S> for …` writes these two methods. The
/// scalar type must be called `S`; tasks, and episodes where a method takes one, must be those of the environment inside.
#[macro_export]
macro_rules! forward {
    (@sources $this:ident $inner:expr) => {
        fn sources(&self) -> Vec<$crate::SourceDocument> {
            let $this = self;
            $inner.sources()
        }
    };
    (@actions $this:ident $inner:expr) => {
        fn actions(&self) -> $crate::ActionSpace {
            let $this = self;
            $inner.actions()
        }
    };
    (@time_limit $this:ident $inner:expr) => {
        fn time_limit(&self) -> u32 {
            let $this = self;
            $inner.time_limit()
        }
    };
    (@draw $this:ident $inner:expr) => {
        fn draw(&self, stream: &mut $crate::random::Stream) -> Self::Task {
            let $this = self;
            $inner.draw(stream)
        }
    };
    (@start $this:ident $inner:expr) => {
        fn start(&self, task: &Self::Task) -> Self::Episode {
            let $this = self;
            $inner.start(task)
        }
    };
    (@observe $this:ident $inner:expr) => {
        fn observe(&self, episode: &mut Self::Episode, wanted: $crate::SourceSet, state: &mut [S]) {
            let $this = self;
            $inner.observe(episode, wanted, state);
        }
    };
    (@step $this:ident $inner:expr) => {
        fn step(&self, episode: &mut Self::Episode, act: $crate::Act<'_, S>) -> $crate::Step {
            let $this = self;
            $inner.step(episode, act)
        }
    };
    (@outcomes $this:ident $inner:expr) => {
        fn outcomes(&self) -> &'static [&'static str] {
            let $this = self;
            $inner.outcomes()
        }
    };
    (@timeout $this:ident $inner:expr) => {
        fn timeout(&self, episode: &Self::Episode) -> $crate::End {
            let $this = self;
            $inner.timeout(episode)
        }
    };
    (@measure $this:ident $inner:expr) => {
        fn measure(&self) -> Option<$crate::Measure> {
            let $this = self;
            $inner.measure()
        }
    };
    (@preference $this:ident $inner:expr) => {
        fn preference(&self) -> $crate::Preference {
            let $this = self;
            $inner.preference()
        }
    };
    (@constants $this:ident $inner:expr) => {
        fn constants(&self) -> Vec<u16> {
            let $this = self;
            $inner.constants()
        }
    };
    (@training $this:ident $inner:expr) => {
        fn training(&self) -> Option<&dyn $crate::Training<Self::Task, Self::Episode>> {
            let $this = self;
            $inner.training()
        }
    };
    (@guarded $this:ident $inner:expr) => {
        fn guarded(&self) -> Option<&dyn $crate::Guarded<S, Self::Episode>> {
            let $this = self;
            $inner.guarded()
        }
    };
    (@drawn $this:ident $inner:expr) => {
        fn drawn(&self) -> Option<&dyn $crate::Drawn<Self::Episode>> {
            let $this = self;
            $inner.drawn()
        }
    };
    (@accepts $this:ident $inner:expr) => {
        fn accepts(&self, task: &Self::Task) -> bool {
            let $this = self;
            $inner.accepts(task)
        }
    };
    (@lanes $this:ident $inner:expr) => {
        fn lanes(&self) -> Box<dyn $crate::Episodes<S, Self::Task> + '_> {
            let $this = self;
            $inner.lanes()
        }
    };
    (@key $this:ident $inner:expr) => {
        fn key(&self, episode: &Self::Episode) -> Option<u64> {
            let $this = self;
            $inner.key(episode)
        }
    };
    (@cycle $this:ident $inner:expr) => {
        fn cycle(&self, episode: &Self::Episode, key: u64, actions: u32) -> Option<$crate::EpisodeResult> {
            let $this = self;
            $inner.cycle(episode, key, actions)
        }
    };
    (@distance $this:ident $inner:expr) => {
        fn distance(&self, episode: &Self::Episode) -> Option<f64> {
            let $this = self;
            $inner.distance(episode)
        }
    };
    ($this:ident => $inner:expr; $($method:ident)*) => {
        $($crate::forward!(@$method $this $inner);)*
    };
}
