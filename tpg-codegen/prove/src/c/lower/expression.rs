//! Expressions: places, values, conditions, conversions.

use super::{Lowering, constant_of, moved, number, promoted, width};
use crate::c::code::{Condition, Constant, Operation, Scalar, Value};
use crate::c::syntax::{Expression, Kind, Type};
use crate::input::Missing;
use crate::term::{Arithmetic, Operator, Width};

impl<'u> Lowering<'u> {
    /// Evaluates an expression for what it does.
    pub(super) fn effect(&mut self, expression: &'u Expression) -> Result<(), Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Assign(operator, target, value) => self.assign(*operator, target, value),
            Kind::Step(up, _, target) => self.step(*up, target),
            Kind::Cast(Type::Void, inner) => self.effect(inner),
            Kind::Call(name, arguments) if name == "memcpy" => self.copy(arguments),
            Kind::Call(name, arguments) => self.call(name, arguments).map(|_| ()),
            Kind::Name(_) => Ok(()),
            _ => self.value(expression).map(|_| ()),
        }
    }

    pub(super) fn assign(
        &mut self,
        operator: Option<&'static str>,
        target: &'u Expression,
        value: &'u Expression,
    ) -> Result<(), Missing> {
        let (address, ty) = self.place(target)?;
        if let (Type::Struct(_), None) = (&ty, operator) {
            let (from, _) = self.place(value)?;
            let count = self.cells(&ty);
            self.emit(Operation::Copy(address, from, count));
            return Ok(());
        }
        let (mut value, mut from) = self.value(value)?;
        if let Some(operator) = operator {
            let before = Value::Load(Box::new(address.clone()), self.scalar(&ty)?);
            (value, from) = self.operated(operator, (before, ty.clone()), (value, from))?;
        }
        let value = self.converted(value, &from, &ty)?;
        self.store(address, value, &ty)
    }

    pub(super) fn step(&mut self, up: bool, target: &'u Expression) -> Result<(), Missing> {
        let (address, ty) = self.place(target)?;
        let before = Value::Load(Box::new(address.clone()), self.scalar(&ty)?);
        let one = (Value::Number(1), Type::INT);
        let (value, from) = self.operated(if up { "+" } else { "-" }, (before, ty.clone()), one)?;
        let value = self.converted(value, &from, &ty)?;
        self.store(address, value, &ty)
    }

    /// `memcpy` of whole scalars; a cell holds its bits, whatever it is read as.
    pub(super) fn copy(&mut self, arguments: &'u [Expression]) -> Result<(), Missing> {
        let [to, from, size] = arguments else { return Err(self.missing("memcpy of three arguments")) };
        let ((to, to_type), (from, from_type)) = (self.value(to)?, self.value(from)?);
        let (size, _) = self.value(size)?;
        let Some(Constant::Number(size)) = constant_of(&size) else { return Err(self.missing("a constant size")) };
        let mut widths = Vec::new();
        for pointer in [&to_type, &from_type] {
            let Type::Pointer(ty) = pointer else { return Err(self.missing("pointers for memcpy")) };
            widths.push(self.scalar_bytes(ty).ok_or_else(|| self.missing("memcpy of mixed scalars"))?);
        }
        if widths[0] != widths[1] || size % u64::from(widths[0]) != 0 {
            return Err(self.missing("memcpy of scalars of one size"));
        }
        let count = u32::try_from(size / u64::from(widths[0])).map_err(|_| self.missing("a smaller memcpy"))?;
        self.emit(Operation::Copy(to, from, count));
        Ok(())
    }

    /// The bytes of each scalar in a type, if all have the same.
    pub(super) fn scalar_bytes(&self, ty: &Type) -> Option<u32> {
        match ty {
            Type::Integer(bytes, _) => Some(u32::from(*bytes)),
            Type::Float => Some(4),
            Type::Array(ty, _) => self.scalar_bytes(ty),
            Type::Struct(number) => {
                let mut sizes = self.unit.structs[*number].members.iter().map(|(_, ty)| self.scalar_bytes(ty));
                let first = sizes.next()??;
                sizes.all(|size| size == Some(first)).then_some(first)
            }
            _ => None,
        }
    }

    pub(super) fn call(
        &mut self,
        name: &'u str,
        arguments: &'u [Expression],
    ) -> Result<Option<(Value, Type)>, Missing> {
        let function = self.function(name)?;
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.value(argument)?);
        }
        let Some(place) = self.inlined(function, values)? else { return Ok(None) };
        let load = Value::Load(Box::new(number(place.address)), self.scalar(&place.ty)?);
        Ok(Some((load, place.ty)))
    }

    /// The address of what an expression names, and its type.
    pub(super) fn place(&mut self, expression: &'u Expression) -> Result<(Value, Type), Missing> {
        match &expression.kind {
            Kind::Name(name) => match self.find(name) {
                Some(place) => Ok((number(place.address), place.ty.clone())),
                None => Err(self.missing(format!("the name `{name}`"))),
            },
            Kind::Unary("*", pointer) => match self.value(pointer)? {
                (address, Type::Pointer(ty)) => Ok((address, *ty)),
                _ => Err(self.missing("a pointer")),
            },
            Kind::Member(structure, name) => {
                let (address, ty) = self.place(structure)?;
                let Type::Struct(structure) = ty else { return Err(self.missing("a structure")) };
                let structure = &self.unit.structs[structure];
                let mut offset = 0;
                for (member, ty) in &structure.members {
                    if member == name {
                        return Ok((moved(address, number(offset)), ty.clone()));
                    }
                    offset += if structure.union { 0 } else { self.cells(ty) };
                }
                Err(self.missing(format!("the member `{name}`")))
            }
            Kind::Index(array, index) => {
                let (index, from) = self.value(index)?;
                if !from.is_integer() {
                    return Err(self.missing("an integer as index"));
                }
                let index = self.converted(index, &from, &Type::UNSIGNED)?;
                let (address, ty, index) = match self.try_place(array)? {
                    Some((address, Type::Array(ty, count))) => {
                        let index = Value::Below(Box::new(index), count);
                        (address, *ty, index)
                    }
                    _ => match self.value(array)? {
                        (address, Type::Pointer(ty)) => (address, *ty, index),
                        _ => return Err(self.missing("an array")),
                    },
                };
                let size = number(self.cells(&ty));
                let offset = Value::Apply(Operator::Multiply, Width::W32, Box::new(index), Box::new(size));
                Ok((moved(address, offset), ty))
            }
            _ => Err(self.missing("something with an address")),
        }
    }

    pub(super) fn try_place(&mut self, expression: &'u Expression) -> Result<Option<(Value, Type)>, Missing> {
        match expression.kind {
            Kind::Name(_) | Kind::Unary("*", _) | Kind::Member(..) | Kind::Index(..) => {
                self.place(expression).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// The value of an expression. Its side effects are emitted before.
    pub(super) fn value(&mut self, expression: &'u Expression) -> Result<(Value, Type), Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Integer(number, ty) => Ok((Value::Number(*number), ty.clone())),
            Kind::Float(value, ty) => Ok((Value::Float((*value as f32).to_bits()), ty.clone())),
            Kind::Name(name) if self.find(name).is_none() => match self.unit.constants.get(name) {
                Some(&value) => Ok((Value::Number(u64::from(value as u32)), Type::INT)),
                None => Err(self.missing(format!("the name `{name}`"))),
            },
            Kind::Name(_) | Kind::Index(..) | Kind::Member(..) | Kind::Unary("*", _) => {
                let (address, ty) = self.place(expression)?;
                match ty {
                    Type::Array(ty, _) => Ok((address, Type::Pointer(ty))),
                    ty => Ok((Value::Load(Box::new(address), self.scalar(&ty)?), ty)),
                }
            }
            Kind::Unary("&", inner) => {
                let (address, ty) = self.place(inner)?;
                Ok((address, Type::Pointer(Box::new(ty))))
            }
            Kind::Unary("!", _) => {
                let condition = self.condition(expression)?;
                Ok((Value::OfCondition(Box::new(condition)), Type::INT))
            }
            Kind::Unary(sign, inner) => {
                let (value, ty) = self.value(inner)?;
                match (*sign, &ty) {
                    ("-", Type::Float) => Ok((Value::Negative(Box::new(value)), ty)),
                    ("-", Type::Double) => match value {
                        Value::Float(bits) => Ok((Value::Float(bits ^ 0x8000_0000), ty)),
                        _ => Err(self.missing("arithmetic in binary64")),
                    },
                    ("+", Type::Float | Type::Double) => Ok((value, ty)),
                    ("-" | "~" | "+", Type::Integer(..)) => {
                        let wide = promoted(&ty);
                        let value = self.converted(value, &ty, &wide)?;
                        let width = width(&wide);
                        let (operator, first) = match *sign {
                            "-" => (Operator::Subtract, 0),
                            "~" => (Operator::Xor, width.mask()),
                            _ => (Operator::Add, 0),
                        };
                        Ok((Value::Apply(operator, width, Box::new(Value::Number(first)), Box::new(value)), wide))
                    }
                    _ => Err(self.missing(format!("`{sign}` of another type"))),
                }
            }
            Kind::Binary("&&" | "||" | "==" | "!=" | "<" | ">" | "<=" | ">=", ..) => {
                let condition = self.condition(expression)?;
                Ok((Value::OfCondition(Box::new(condition)), Type::INT))
            }
            Kind::Binary(operator, a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.line = expression.line;
                self.operated(operator, a, b)
            }
            Kind::Conditional(condition, a, b) => self.chosen(condition, a, b),
            Kind::Cast(ty, inner) => {
                let (value, from) = self.value(inner)?;
                Ok((self.converted(value, &from, ty)?, ty.clone()))
            }
            Kind::Call(name, arguments) => match (name.as_str(), &arguments[..]) {
                ("fabsf", [inner]) => {
                    let (value, from) = self.value(inner)?;
                    let value = self.converted(value, &from, &Type::Float)?;
                    Ok((Value::Magnitude(Box::new(value)), Type::Float))
                }
                ("isnan", [_]) => {
                    let condition = self.condition(expression)?;
                    Ok((Value::OfCondition(Box::new(condition)), Type::INT))
                }
                _ => self.call(name, arguments)?.ok_or_else(|| self.missing(format!("a result of `{name}`"))),
            },
            Kind::Assign(_, target, _) | Kind::Step(_, false, target) => {
                self.effect(expression)?;
                self.value(target)
            }
            Kind::Step(_, true, target) => {
                let (value, ty) = self.value(target)?;
                let cell = self.allocate(&ty);
                self.store(number(cell), value, &ty)?;
                self.effect(expression)?;
                Ok((Value::Load(Box::new(number(cell)), self.scalar(&ty)?), ty))
            }
            Kind::SizeOf(inner) => {
                let mark = self.here();
                let ty = match self.try_place(inner)? {
                    Some((_, ty)) => ty,
                    None => self.value(inner)?.1,
                };
                self.program.operations.truncate(mark);
                Ok((number(self.bytes(&ty)), Type::UNSIGNED))
            }
            Kind::SizeOfType(ty) => Ok((number(self.bytes(ty)), Type::UNSIGNED)),
            Kind::List(_) => Err(self.missing("braces here")),
        }
    }

    pub(super) fn chosen(
        &mut self,
        condition: &'u Expression,
        a: &'u Expression,
        b: &'u Expression,
    ) -> Result<(Value, Type), Missing> {
        let condition = self.condition(condition)?;
        let mark = self.here();
        let ((first, x), (second, y)) = (self.value(a)?, self.value(b)?);
        let ty = if x == y && !x.is_integer() { x.clone() } else { self.common(&x, &y)? };
        if self.here() == mark {
            let (first, second) = (self.converted(first, &x, &ty)?, self.converted(second, &y, &ty)?);
            return Ok((Value::If(Box::new(condition), Box::new(first), Box::new(second)), ty));
        }
        // something happens on the way: only on the side that is chosen
        self.program.operations.truncate(mark);
        let cell = self.allocate(&ty);
        let branch = self.emit(Operation::Branch(condition, usize::MAX));
        let (first, x) = self.value(a)?;
        let first = self.converted(first, &x, &ty)?;
        self.store(number(cell), first, &ty)?;
        let end = self.jump(self.scopes.len());
        self.land(&[branch]);
        let (second, y) = self.value(b)?;
        let second = self.converted(second, &y, &ty)?;
        self.store(number(cell), second, &ty)?;
        self.land(&[end]);
        Ok((Value::Load(Box::new(number(cell)), self.scalar(&ty)?), ty))
    }

    /// An expression as a condition.
    pub(super) fn condition(&mut self, expression: &'u Expression) -> Result<Condition, Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Unary("!", inner) => Ok(Condition::Not(Box::new(self.condition(inner)?))),
            Kind::Binary(sign @ ("&&" | "||"), a, b) => {
                let first = self.condition(a)?;
                let mark = self.here();
                let second = self.condition(b)?;
                if self.here() != mark {
                    // what happens in the second operand happens only if the first asks for it
                    self.program.operations.truncate(mark);
                    return self.lazily(*sign == "&&", first, b);
                }
                let (first, second) = (Box::new(first), Box::new(second));
                Ok(if *sign == "&&" { Condition::And(first, second) } else { Condition::Or(first, second) })
            }
            Kind::Binary(sign @ ("==" | "!=" | "<" | ">" | "<=" | ">="), a, b) => {
                let ((a, x), (b, y)) = (self.value(a)?, self.value(b)?);
                self.line = expression.line;
                self.compared(sign, (a, x), (b, y))
            }
            Kind::Call(name, arguments) if name == "isnan" && arguments.len() == 1 => {
                let (value, from) = self.value(&arguments[0])?;
                Ok(Condition::Nan(self.converted(value, &from, &Type::Float)?))
            }
            _ => {
                let (value, ty) = self.value(expression)?;
                match ty {
                    Type::Integer(..) => Ok(Condition::NonZero(width(&ty), value)),
                    Type::Float => Ok(Condition::Not(Box::new(Condition::Equal(value, Value::Float(0))))),
                    _ => Err(self.missing("a condition of another type")),
                }
            }
        }
    }

    pub(super) fn lazily(&mut self, and: bool, first: Condition, second: &'u Expression) -> Result<Condition, Missing> {
        let cell = self.allocate(&Type::INT);
        self.store(number(cell), Value::Number(u64::from(!and)), &Type::INT)?;
        let first = if and { first } else { Condition::Not(Box::new(first)) };
        let branch = self.emit(Operation::Branch(first, usize::MAX));
        let second = self.condition(second)?;
        self.store(number(cell), Value::OfCondition(Box::new(second)), &Type::INT)?;
        self.land(&[branch]);
        Ok(Condition::NonZero(Width::W32, Value::Load(Box::new(number(cell)), Scalar::Word(Width::W32))))
    }

    pub(super) fn compared(
        &mut self,
        sign: &str,
        (a, x): (Value, Type),
        (b, y): (Value, Type),
    ) -> Result<Condition, Missing> {
        if self.common(&x, &y)? == Type::Float {
            let (a, b) = (self.converted(a, &x, &Type::Float)?, self.converted(b, &y, &Type::Float)?);
            return Ok(match sign {
                "==" => Condition::Equal(a, b),
                "!=" => Condition::Not(Box::new(Condition::Equal(a, b))),
                "<" => Condition::Less(a, b),
                ">" => Condition::Less(b, a),
                "<=" => Condition::LessOrEqual(a, b),
                _ => Condition::LessOrEqual(b, a),
            });
        }
        let ty = self.common(&x, &y)?;
        let (a, b) = (self.converted(a, &x, &ty)?, self.converted(b, &y, &ty)?);
        let Type::Integer(_, signed) = ty else { return Err(self.missing("a comparison of another type")) };
        let width = width(&ty);
        let not = |condition| Condition::Not(Box::new(condition));
        Ok(match sign {
            "==" => Condition::Same(width, a, b),
            "!=" => not(Condition::Same(width, a, b)),
            "<" => Condition::Below(signed, width, a, b),
            ">" => Condition::Below(signed, width, b, a),
            "<=" => not(Condition::Below(signed, width, b, a)),
            _ => not(Condition::Below(signed, width, a, b)),
        })
    }

    pub(super) fn operated(
        &mut self,
        sign: &str,
        (a, x): (Value, Type),
        (b, y): (Value, Type),
    ) -> Result<(Value, Type), Missing> {
        if let (Type::Pointer(ty), "+", Type::Integer(..)) = (&x, sign, &y) {
            let index = self.converted(b, &y, &Type::UNSIGNED)?;
            let size = number(self.cells(ty));
            let offset = Value::Apply(Operator::Multiply, Width::W32, Box::new(index), Box::new(size));
            return Ok((moved(a, offset), x));
        }
        let shifts = matches!(sign, "<<" | ">>");
        let ty = if shifts { promoted(&x) } else { self.common(&x, &y)? };
        if ty == Type::Float {
            let (a, b) = (self.converted(a, &x, &ty)?, self.converted(b, &y, &ty)?);
            let (operation, b) = match sign {
                "+" => (Arithmetic::Add, b),
                "-" => (Arithmetic::Add, Value::Negative(Box::new(b))),
                "*" => (Arithmetic::Multiply, b),
                "/" => (Arithmetic::Divide, b),
                _ => return Err(self.missing(format!("`{sign}` of floats"))),
            };
            return Ok((Value::Arithmetic(operation, Box::new(a), Box::new(b)), ty));
        }
        let Type::Integer(_, signed) = ty else { return Err(self.missing(format!("`{sign}` of this type"))) };
        let operator = match sign {
            "+" => Operator::Add,
            "-" => Operator::Subtract,
            "*" => Operator::Multiply,
            "/" if !signed => Operator::Divide,
            "%" if !signed => Operator::Modulo,
            "&" => Operator::And,
            "|" => Operator::Or,
            "^" => Operator::Xor,
            "<<" => Operator::ShiftLeft,
            ">>" if signed => Operator::ShiftArithmetic,
            ">>" => Operator::ShiftRight,
            _ => return Err(self.missing(format!("`{sign}` of signed integers"))),
        };
        let a = self.converted(a, &x, &ty)?;
        let b = if shifts { self.converted(b, &y, &Type::UNSIGNED)? } else { self.converted(b, &y, &ty)? };
        Ok((Value::Apply(operator, width(&ty), Box::new(a), Box::new(b)), ty))
    }

    /// The type in which two operands are computed with.
    pub(super) fn common(&self, x: &Type, y: &Type) -> Result<Type, Missing> {
        match (x, y) {
            (Type::Double, _) | (_, Type::Double) => Err(self.missing("arithmetic in binary64")),
            (Type::Float, Type::Float | Type::Integer(..)) | (Type::Integer(..), Type::Float) => Ok(Type::Float),
            (Type::Integer(..), Type::Integer(..)) => {
                let (Type::Integer(a, s), Type::Integer(b, t)) = (promoted(x), promoted(y)) else {
                    return Err(self.missing("integers"));
                };
                // the wider one, or unsigned if either of the same size is
                Ok(Type::Integer(
                    a.max(b),
                    if a == b {
                        s && t
                    } else if a > b {
                        s
                    } else {
                        t
                    },
                ))
            }
            _ => Err(self.missing("operands of another type")),
        }
    }

    pub(super) fn converted(&self, value: Value, from: &Type, to: &Type) -> Result<Value, Missing> {
        let apply =
            |operator, width, a: Value, b: u64| Value::Apply(operator, width, Box::new(a), Box::new(Value::Number(b)));
        match (from, to) {
            _ if from == to => Ok(value),
            (Type::Pointer(_), Type::Pointer(_)) | (_, Type::Void) => Ok(value),
            // a constant of the wider type: it is rounded once more
            (Type::Double, Type::Float) if matches!(value, Value::Float(_)) => Ok(value),
            (Type::Integer(bytes, signed), Type::Float) if *bytes <= 4 => {
                Ok(Value::OfInteger(*signed, Box::new(value)))
            }
            (Type::Float, Type::Integer(..)) => Err(self.missing("a float that is in the range of an integer")),
            (Type::Integer(a, signed), Type::Integer(b, to_signed)) => Ok(match (a, b) {
                (8, 8) => value,
                (_, 8) if *signed => {
                    let flipped = apply(Operator::Xor, Width::W64, value, 0x8000_0000);
                    apply(Operator::Subtract, Width::W64, flipped, 0x8000_0000)
                }
                (_, 8) => value,
                (8, _) | (_, 1 | 2) if *to_signed && *b < 4 => {
                    let unused = 32 - 8 * u64::from(*b);
                    let upper = apply(Operator::ShiftLeft, Width::W32, value, unused);
                    apply(Operator::ShiftArithmetic, Width::W32, upper, unused)
                }
                (8, _) | (_, 1 | 2) => {
                    let width = if *a == 8 { Width::W64 } else { Width::W32 };
                    apply(Operator::And, width, value, (1 << (8 * u64::from(*b))) - 1)
                }
                _ => value,
            }),
            _ => Err(self.missing(format!("a conversion from {from:?} to {to:?}"))),
        }
    }
}
