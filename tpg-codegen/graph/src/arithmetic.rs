//! Dispatch from the arithmetic that a graph names to the types that compute in it.

/// Calls a function that is generic over scalar and maths with the types that a graph names.
///
/// ```
/// use tpg_graph::Graph;
/// use tpg_graph::in_arithmetic_of;
/// use tpg_runtime::ops::Maths;
/// use tpg_runtime::scalar::Scalar;
///
/// fn bytes<S: Scalar, M: Maths<S>>(values: usize) -> usize {
///     values * size_of::<S>()
/// }
///
/// fn state_bytes(graph: &Graph) -> usize {
///     in_arithmetic_of!(graph, bytes(graph.state_length()))
/// }
/// ```
#[macro_export]
macro_rules! in_arithmetic_of {
    ($graph:expr, $($function:ident).+ ( $($argument:expr),* $(,)? )) => {
        match ($graph.scalar(), $graph.maths()) {
            ($crate::ScalarType::F32, $crate::MathsProvider::Own) =>
                $($function).+::<f32, ::tpg_runtime::ops::Own>($($argument),*),
            ($crate::ScalarType::F32, $crate::MathsProvider::System) =>
                $($function).+::<f32, ::tpg_runtime::ops::System>($($argument),*),
            ($crate::ScalarType::F64, $crate::MathsProvider::Own) =>
                $($function).+::<f64, ::tpg_runtime::ops::Own>($($argument),*),
            ($crate::ScalarType::F64, $crate::MathsProvider::System) =>
                $($function).+::<f64, ::tpg_runtime::ops::System>($($argument),*),
        }
    };
}
