//! Operators on values, and conversions.

use super::{Compiler, Type, Typed, apply, width};
use crate::code::{Computed, Expression, of};
use crate::input::Result;
use crate::term::{Arithmetic, Operator::*, Terms};
use Computed::{Below, Compared, Same};
use Type::*;

pub(super) fn promoted(ty: &Type) -> Type {
    match ty {
        Integer(1 | 2, _) => Type::INT,
        ty => ty.clone(),
    }
}

impl Compiler<'_> {
    pub(super) fn compared(&self, sign: &str, a: Typed, b: Typed) -> Result<Expression> {
        let ty = self.common(&a.1, &b.1)?;
        let (mut a, mut b) = (self.converted(a, &ty)?, self.converted(b, &ty)?);
        if sign.starts_with('>') {
            (a, b) = (b, a);
        }
        let (width, signed) = (width(&ty), ty != Type::UNSIGNED && ty != Integer(8, false));
        let condition = match (&ty, sign) {
            (Float, "==" | "!=") => of(Compared(Terms::equal), [a, b]),
            (Float, "<" | ">") => of(Compared(Terms::less), [a, b]),
            (Float, _) => of(Compared(Terms::less_or_equal), [a, b]),
            (_, "==" | "!=") => of(Same(width), [a, b]),
            (_, "<" | ">") => of(Below(signed, width), [a, b]),
            _ => !of(Below(signed, width), [b, a]),
        };
        Ok(if sign == "!=" { !condition } else { condition })
    }

    pub(super) fn operated(&self, sign: &str, a: Typed, b: Typed) -> Result<Typed> {
        let shifts = matches!(sign, "<<" | ">>");
        let ty = if shifts { promoted(&a.1) } else { self.common(&a.1, &b.1)? };
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
        let operator = match sign {
            "+" => Add,
            "-" => Subtract,
            "*" => Multiply,
            "&" => And,
            "|" => Or,
            "^" => Xor,
            "<<" => ShiftLeft,
            ">>" if signed => ShiftArithmetic,
            ">>" => ShiftRight,
            _ => return self.refuse(format!("`{sign}` of integers")),
        };
        Ok((apply(operator, width(&ty), a, b), ty))
    }

    /// The type in which two operands are computed with.
    pub(super) fn common(&self, x: &Type, y: &Type) -> Result<Type> {
        match (promoted(x), promoted(y)) {
            (Float, Float | Integer(..)) | (Integer(..), Float) => Ok(Float),
            // the only signed type is narrower than the unsigned ones, or as wide
            (Integer(a, s), Integer(b, t)) => Ok(Integer(a.max(b), s && t)),
            _ => self.refuse("operands of another type"),
        }
    }

    pub(super) fn converted(&self, (value, from): Typed, to: &Type) -> Result<Expression> {
        match (&from, to) {
            _ if from == *to => Ok(value),
            (Pointer(_), Pointer(_)) => Ok(value),
            (Integer(bytes, signed), Float) if *bytes <= 4 => Ok(of(Computed::OfInteger(*signed), [value])),
            (Float, Integer(..)) => self.refuse("a float that is in the range of an integer"),
            (Integer(_, true), Integer(8, _)) => self.refuse("an unsigned integer"),
            (Integer(a, _), Integer(b, _)) if *b < 4 || *a == 8 && *b == 4 => {
                let mask = Expression::Number((1 << (8 * u64::from(*b))) - 1);
                Ok(apply(And, width(&from), value, mask))
            }
            (Integer(..), Integer(..)) => Ok(value),
            _ => self.refuse(format!("a conversion from {from:?} to {to:?}")),
        }
    }
}
