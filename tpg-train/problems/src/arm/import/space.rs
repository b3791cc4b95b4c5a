//! Vectors and rotations.

/// A point or a direction.
pub(super) type Vector = [f64; 3];
/// A rotation, as the rows of its matrix.
pub(super) type Rotation = [Vector; 3];

pub(super) const X: Vector = [1.0, 0.0, 0.0];
pub(super) const Y: Vector = [0.0, 1.0, 0.0];
pub(super) const Z: Vector = [0.0, 0.0, 1.0];
pub(super) const NO_ROTATION: Rotation = [X, Y, Z];

pub(super) fn plus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|axis| a[axis] + b[axis])
}

pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

pub(super) fn times(factor: f64, a: Vector) -> Vector {
    a.map(|value| factor * value)
}

pub(super) fn dot([a, b, c]: Vector, [x, y, z]: Vector) -> f64 {
    a * x + b * y + c * z
}

pub(super) fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub(super) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Returns the direction of a vector; `None` if it has none.
pub(super) fn direction(a: Vector) -> Option<Vector> {
    let length = norm(a);
    (length > 1e-9).then(|| a.map(|value| value / length))
}

pub(super) fn rotate(rotation: &Rotation, a: Vector) -> Vector {
    rotation.map(|row| dot(row, a))
}

/// Returns the inverse of a rotation.
pub(super) fn inverse(rotation: &Rotation) -> Rotation {
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| rotation[column][row]))
}

/// Returns the rotation that makes the second one first.
pub(super) fn compose(a: &Rotation, b: &Rotation) -> Rotation {
    let columns = inverse(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

/// Returns the rotation about a direction (Rodrigues).
pub(super) fn about(axis: Vector, angle: f64) -> Rotation {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let column = |unit: Vector| {
        let along = times((1.0 - cos) * dot(axis, unit), axis);
        plus(plus(times(cos, unit), times(sin, cross(axis, unit))), along)
    };
    inverse(&[X, Y, Z].map(column))
}
