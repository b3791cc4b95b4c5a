//! Operators on values, and conversions.

use super::{Compiler, Type, Typed, width};
use crate::code::{Computed, Expression, Integral, Kind, of};
use crate::input::Result;
use crate::term::{Arithmetic, Operator::*, Terms};
use Computed::Compared;
use Type::*;

impl Compiler<'_> {
    /// The bytes of an `int`: with counts, what it computes holds in 16 bits, and so in more.
    pub(super) fn int(&self) -> u8 {
        if self.exact { 2 } else { 4 }
    }

    pub(super) fn promoted(&self, ty: &Type) -> Type {
        match *ty {
            Integer(bytes, signed) if bytes < self.int() || bytes == self.int() && signed => Integer(self.int(), true),
            _ => ty.clone(),
        }
    }

    pub(super) fn compared(&self, sign: &str, a: Typed, b: Typed) -> Result<Expression> {
        let ty = self.common(&a.1, &b.1)?;
        let (mut a, mut b) = (self.converted(a, &ty)?, self.converted(b, &ty)?);
        if sign.starts_with('>') {
            (a, b) = (b, a);
        }
        let condition = match (&ty, sign) {
            (Float, "==" | "!=") => of(Compared(Terms::equal), [a, b]),
            (Float, "<" | ">") => of(Compared(Terms::less), [a, b]),
            (Float, _) => of(Compared(Terms::less_or_equal), [a, b]),
            (_, "==" | "!=") => self.integral(Integral::Same, &ty, [a, b]),
            (_, "<" | ">") => self.integral(Integral::Below, &ty, [a, b]),
            _ => !self.integral(Integral::Below, &ty, [b, a]),
        };
        Ok(if sign == "!=" { !condition } else { condition })
    }

    pub(super) fn operated(&self, sign: &str, a: Typed, b: Typed) -> Result<Typed> {
        let shifts = matches!(sign, "<<" | ">>");
        let ty = if shifts { self.promoted(&a.1) } else { self.common(&a.1, &b.1)? };
        let (a, b) = (self.converted(a, &ty)?, self.converted(b, if shifts { &Type::UNSIGNED } else { &ty })?);
        if ty == Float {
            let (operation, b) = match sign {
                "+" => (Arithmetic::Add, b),
                "-" => (Arithmetic::Add, of(Computed::Negative, [b])),
                "*" => (Arithmetic::Multiply, b),
                "/" => (Arithmetic::Divide, b),
                _ => return self.refuse(format!("`{sign}` of floats")),
            };
            return Ok((of(Computed::Arithmetic(operation), [a, b]), ty));
        }
        let Integer(_, signed) = ty else { return self.refuse(format!("`{sign}` of this type")) };
        // shifts by the width or more have no meaning
        let b = if shifts { of(Computed::Bounded(width(&ty).bits()), [b]) } else { b };
        let what = match sign {
            "+" => Integral::Apply(Add),
            "-" => Integral::Apply(Subtract),
            "*" => Integral::Apply(Multiply),
            "/" => Integral::Divide,
            "%" => Integral::Remainder,
            "&" => Integral::Apply(And),
            "|" => Integral::Apply(Or),
            "^" => Integral::Apply(Xor),
            "<<" => Integral::Apply(ShiftLeft),
            ">>" if signed => Integral::Apply(ShiftArithmetic),
            ">>" => Integral::Apply(ShiftRight),
            _ => return self.refuse(format!("`{sign}` of integers")),
        };
        Ok((self.integral(what, &ty, [a, b]), ty))
    }

    /// A type of integers; anything else is as wide as an `int`.
    pub(super) fn kind(&self, ty: &Type) -> Kind {
        let (bytes, signed) = if let Integer(bytes, signed) = *ty { (bytes, signed) } else { (4, false) };
        Kind { bytes, signed, exact: self.exact }
    }

    /// An operation in a type of integers.
    pub(super) fn integral<const N: usize>(&self, what: Integral, ty: &Type, parts: [Expression; N]) -> Expression {
        of(Computed::Integer(what, self.kind(ty)), parts)
    }

    /// The type in which two operands are computed with.
    pub(super) fn common(&self, x: &Type, y: &Type) -> Result<Type> {
        match (self.promoted(x), self.promoted(y)) {
            (Float, Float | Integer(..)) | (Integer(..), Float) => Ok(Float),
            (Integer(a, s), Integer(b, t)) if a == b => Ok(Integer(a, s && t)),
            (x @ Integer(a, _), y @ Integer(b, _)) => Ok(if a > b { x } else { y }),
            _ => self.refuse("operands of another type"),
        }
    }

    pub(super) fn converted(&self, (value, from): Typed, to: &Type) -> Result<Expression> {
        match (&from, to) {
            (Integer(..), Integer(_, signed)) if from != *to || self.exact && *signed => {
                Ok(self.integral(Integral::From(self.kind(&from)), to, [value]))
            }
            _ if from == *to => Ok(value),
            (Pointer(_), Pointer(_)) => Ok(value),
            (Integer(bytes, signed), Float) if *bytes <= 4 => Ok(of(Computed::OfInteger(*signed), [value])),
            (Float, Integer(..)) => self.refuse("a float that is in the range of an integer"),
            _ => self.refuse(format!("a conversion from {from:?} to {to:?}")),
        }
    }
}
