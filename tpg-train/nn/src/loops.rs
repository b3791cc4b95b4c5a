//! The loops of a training step, compiled in this crate for both number types.

use crate::{Adam, Gaussian, Mlp, Samples, Tape};

/// The loops of a training step. Each is documented where it is called, at the method of the same name.
///
/// They are methods of a trait, not generic functions, so that they are compiled here and not once more in every crate
/// that trains, and are as fast as this crate is, however little the other is optimised.
pub trait Loops: Sized {
    /// Implements [`Mlp::forward`].
    fn forward(network: &Mlp<Self>, tape: &mut Tape<Self>);
    /// Implements [`Mlp::backward`].
    fn backward(
        network: &Mlp<Self>,
        tape: &mut Tape<Self>,
        by_output: &[Self],
        gradients: Option<&mut [Self]>,
        by_input: Option<&mut [Self]>,
    );
    /// Implements [`Mlp::follow`].
    fn follow(network: &mut Mlp<Self>, other: &Mlp<Self>, rate: Self);
    /// Implements [`Adam::step`].
    fn step(adam: &mut Adam<Self>, parameters: &mut [Self], gradient: &[Self], rate: f64);
    /// Implements [`Gaussian::sample`].
    fn sample(gaussian: Gaussian, outputs: &[Self], noise: &[Self], samples: &mut Samples<Self>);
    /// Implements [`Gaussian::backward`].
    fn sample_backward(
        gaussian: Gaussian,
        samples: &Samples<Self>,
        noise: &[Self],
        by_actions: &[Self],
        by_density: Self,
        by_outputs: &mut [Self],
    );
}

macro_rules! loops {
    ($($type:ty),*) => {
        $(
            impl Loops for $type {
                fn forward(network: &Mlp<Self>, tape: &mut Tape<Self>) {
                    network.compute_forward(tape);
                }
                fn backward(
                    network: &Mlp<Self>,
                    tape: &mut Tape<Self>,
                    by_output: &[Self],
                    gradients: Option<&mut [Self]>,
                    by_input: Option<&mut [Self]>,
                ) {
                    network.compute_backward(tape, by_output, gradients, by_input);
                }
                fn follow(network: &mut Mlp<Self>, other: &Mlp<Self>, rate: Self) {
                    network.compute_follow(other, rate);
                }
                fn step(adam: &mut Adam<Self>, parameters: &mut [Self], gradient: &[Self], rate: f64) {
                    adam.compute_step(parameters, gradient, rate);
                }
                fn sample(gaussian: Gaussian, outputs: &[Self], noise: &[Self], samples: &mut Samples<Self>) {
                    gaussian.compute_sample(outputs, noise, samples);
                }
                fn sample_backward(
                    gaussian: Gaussian,
                    samples: &Samples<Self>,
                    noise: &[Self],
                    by_actions: &[Self],
                    by_density: Self,
                    by_outputs: &mut [Self],
                ) {
                    gaussian.compute_backward(samples, noise, by_actions, by_density, by_outputs);
                }
            }
        )*
    };
}

loops!(f32, f64);
