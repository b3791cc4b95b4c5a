//! The problems that come with the trainer.
//!
//! | module | subject |
//! | --- | --- |
//! | [`arm`] | reaching with a robot arm |
//! | [`pendulum`] | swinging a pendulum up |

pub mod arm;
pub mod pendulum;

pub use pendulum::Pendulum;
