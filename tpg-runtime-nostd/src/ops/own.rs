//! T
#![allow(missing_docs)]
pub mod f32 {
    pub fn sin(x: f32) -> f32 {
        libm::sinf(x)
    }
    pub fn cos(x: f32) -> f32 {
        libm::cosf(x)
    }
    pub fn ln(x: f32) -> f32 {
        libm::logf(x)
    }
    pub fn exp(x: f32) -> f32 {
        libm::expf(x)
    }
}
pub mod f64 {
    pub fn sin(x: f64) -> f64 {
        libm::sin(x)
    }
    pub fn cos(x: f64) -> f64 {
        libm::cos(x)
    }
    pub fn ln(x: f64) -> f64 {
        libm::log(x)
    }
    pub fn exp(x: f64) -> f64 {
        libm::exp(x)
    }
}
