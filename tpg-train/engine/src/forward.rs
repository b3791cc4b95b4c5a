//! Environments that wrap another one.

/// Forwards methods of [`Environment<S>`](crate::Environment) to the environment inside.
///
/// `forward!(this => this.inner; draw time_limit)` within `impl<S: Scalar, …> Environment<S> for …` writes these two methods. The
/// scalar type must be called `S`; tasks, and episodes where a method takes one, must be those of the environment inside.
#[macro_export]
macro_rules! forward {
    (@sources $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, sources() -> Vec<$crate::SourceDocument>);
    };
    (@actions $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, actions() -> $crate::ActionSpace);
    };
    (@time_limit $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, time_limit() -> u32);
    };
    (@draw $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, draw(stream: &mut $crate::random::Stream) -> Self::Task);
    };
    (@start $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, start(task: &Self::Task) -> Self::Episode);
    };
    (@observe_some $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, observe_some(
            episode: &mut Self::Episode, wanted: $crate::SourceSet, inputs: &[u16], state: &mut [S]
        ) -> ());
    };
    (@observe $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, observe(episode: &mut Self::Episode, wanted: $crate::SourceSet, state: &mut [S]) -> ());
    };
    (@step $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, step(episode: &mut Self::Episode, act: $crate::Act<'_, S>) -> $crate::Step);
    };
    (@outcomes $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, outcomes() -> &'static [&'static str]);
    };
    (@timeout $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, timeout(episode: &Self::Episode) -> $crate::End);
    };
    (@measure $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, measure() -> Option<$crate::Measure>);
    };
    (@preference $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, preference() -> $crate::Preference);
    };
    (@training $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, training() -> Option<&dyn $crate::Training<Self::Task, Self::Episode>>);
    };
    (@guarded $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, guarded() -> Option<&dyn $crate::Guarded<S, Self::Episode>>);
    };
    (@drawn $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, drawn() -> Option<&dyn $crate::Drawn<Self::Episode>>);
    };
    (@accepts $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, accepts(task: &Self::Task) -> bool);
    };
    (@lanes $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, lanes() -> Box<dyn $crate::Episodes<S, Self::Task> + '_>);
    };
    (@key $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, key(episode: &Self::Episode) -> Option<u64>);
    };
    (@cycle $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, cycle(episode: &Self::Episode, key: u64, actions: u32) -> Option<$crate::EpisodeResult>);
    };
    (@distance $this:ident $inner:expr) => {
        $crate::forward!(@method $this $inner, distance(episode: &Self::Episode) -> Option<f64>);
    };
    (@method $this:ident $inner:expr, $name:ident($($argument:ident: $type:ty),*) -> $result:ty) => {
        fn $name(&self, $($argument: $type),*) -> $result {
            let $this = self;
            $inner.$name($($argument),*)
        }
    };
    ($this:ident => $inner:expr; $($method:ident)*) => {
        $($crate::forward!(@$method $this $inner);)*
    };
}
