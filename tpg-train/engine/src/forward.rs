//! Environments that wrap another one.

/// Forwards methods of [`Environment<S>`](crate::Environment) to the environment inside.
///
/// `forward!(this => this.inner; draw time_limit)` within `impl<S: Scalar, …> Environment<S> for …` writes these two methods. The
/// scalar type must be called `S`; tasks, and episodes where a method takes one, must be those of the environment inside.
#[macro_export]
macro_rules! forward {
    (@sources $wrapper:tt) => {
        $crate::forward!(@method $wrapper sources() -> Vec<$crate::SourceDocument>);
    };
    (@actions $wrapper:tt) => {
        $crate::forward!(@method $wrapper actions() -> $crate::ActionSpace);
    };
    (@time_limit $wrapper:tt) => {
        $crate::forward!(@method $wrapper time_limit() -> u32);
    };
    (@draw $wrapper:tt) => {
        $crate::forward!(@method $wrapper draw(stream: &mut $crate::random::Stream) -> Self::Task);
    };
    (@start $wrapper:tt) => {
        $crate::forward!(@method $wrapper start(task: &Self::Task) -> Self::Episode);
    };
    (@observe_some $wrapper:tt) => {
        $crate::forward!(@method $wrapper observe_some(
            episode: &mut Self::Episode, wanted: $crate::SourceSet, inputs: &[u16], state: &mut [S]
        ) -> ());
    };
    (@observe $wrapper:tt) => {
        $crate::forward!(@method $wrapper observe(episode: &mut Self::Episode, wanted: $crate::SourceSet, state: &mut [S]) -> ());
    };
    (@step $wrapper:tt) => {
        $crate::forward!(@method $wrapper step(episode: &mut Self::Episode, act: $crate::Act<'_, S>) -> $crate::Step);
    };
    (@outcomes $wrapper:tt) => {
        $crate::forward!(@method $wrapper outcomes() -> &'static [&'static str]);
    };
    (@timeout $wrapper:tt) => {
        $crate::forward!(@method $wrapper timeout(episode: &Self::Episode) -> $crate::End);
    };
    (@measure $wrapper:tt) => {
        $crate::forward!(@method $wrapper measure() -> Option<$crate::Measure>);
    };
    (@preference $wrapper:tt) => {
        $crate::forward!(@method $wrapper preference() -> $crate::Preference);
    };
    (@training $wrapper:tt) => {
        $crate::forward!(@method $wrapper training() -> Option<&dyn $crate::Training<Self::Task>>);
    };
    (@task_from $wrapper:tt) => {
        $crate::forward!(@method $wrapper task_from(episode: &Self::Episode) -> Option<Self::Task>);
    };
    (@guarded $wrapper:tt) => {
        $crate::forward!(@method $wrapper guarded() -> Option<&dyn $crate::Guarded<S, Self::Episode>>);
    };
    (@moment $wrapper:tt) => {
        $crate::forward!(@method $wrapper moment(episode: &Self::Episode) -> Vec<f64>);
    };
    (@accepts $wrapper:tt) => {
        $crate::forward!(@method $wrapper accepts(task: &Self::Task) -> bool);
    };
    (@lanes $wrapper:tt) => {
        $crate::forward!(@method $wrapper lanes() -> Box<dyn $crate::Episodes<S, Self::Task> + '_>);
    };
    (@key $wrapper:tt) => {
        $crate::forward!(@method $wrapper key(episode: &Self::Episode) -> Option<u64>);
    };
    (@cycle $wrapper:tt) => {
        $crate::forward!(@method $wrapper cycle(episode: &Self::Episode, key: u64, actions: u32) -> Option<$crate::EpisodeResult>);
    };
    (@distance $wrapper:tt) => {
        $crate::forward!(@method $wrapper distance(episode: &Self::Episode) -> Option<f64>);
    };
    (@method ($this:ident $inner:expr) $name:ident($($argument:ident: $type:ty),*) -> $result:ty) => {
        fn $name(&self, $($argument: $type),*) -> $result {
            let $this = self;
            $inner.$name($($argument),*)
        }
    };
    ($this:ident => $inner:expr; $($method:ident)*) => {
        $($crate::forward!(@$method ($this $inner));)*
    };
}
