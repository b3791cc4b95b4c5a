//! Expressions: places, values, conditions, conversions.

use super::{Lowering, apply, constant_of, moved, number, promoted, width};
use crate::c::code::{Condition, Constant, Operation, Value};
use crate::c::syntax::{Expression, Kind, Type};
use crate::input::Missing;
use crate::term::{Arithmetic, Operator::*, Terms, Width};
use Condition::*;
use Type::*;

impl<'u> Lowering<'u> {
    /// Evaluates an expression for what it does.
    pub(super) fn effect(&mut self, expression: &'u Expression) -> Result<(), Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Assign(operator, target, value) => self.assign(*operator, target, value),
            Kind::Postfix(assignment) => self.effect(assignment),
            Kind::Cast(Void, inner) => self.effect(inner),
            Kind::Call(name, arguments) if name == "memcpy" => self.copy(arguments),
            Kind::Call(name, arguments) => self.call(name, arguments).map(|_| ()),
            Kind::Name(_) => Ok(()),
            _ => self.value(expression).map(|_| ()),
        }
    }

    fn assign(
        &mut self,
        operator: Option<&'static str>,
        target: &'u Expression,
        value: &'u Expression,
    ) -> Result<(), Missing> {
        let (address, ty) = self.place(target)?;
        let Some(operator) = operator else { return self.set(address, &ty, value) };
        let value = self.value(value)?;
        let before = self.loaded(address.clone(), ty.clone())?;
        let value = self.operated(operator, before, value)?;
        self.put(address, value, &ty)
    }

    /// Sets what is at an address to the value of an expression.
    pub(super) fn set(&mut self, address: Value, ty: &Type, value: &'u Expression) -> Result<(), Missing> {
        if let Struct(_) = ty {
            let (from, _) = self.place(value)?;
            let count = self.cells(ty);
            self.emit(Operation::Copy(address, from, count));
            return Ok(());
        }
        let value = self.value(value)?;
        self.put(address, value, ty)
    }

    /// `memcpy` of whole scalars; a cell holds its bits, whatever it is read as.
    fn copy(&mut self, arguments: &'u [Expression]) -> Result<(), Missing> {
        let [to, from, size] = arguments else { return Err(self.missing("memcpy of three arguments")) };
        let ((to, to_type), (from, from_type)) = (self.value(to)?, self.value(from)?);
        let (size, _) = self.value(size)?;
        let Some(Constant::Number(size)) = constant_of(&size) else { return Err(self.missing("a constant size")) };
        let mut widths = Vec::new();
        for pointer in [&to_type, &from_type] {
            let Pointer(ty) = pointer else { return Err(self.missing("pointers for memcpy")) };
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
    fn scalar_bytes(&self, ty: &Type) -> Option<u32> {
        match ty {
            Integer(bytes, _) => Some(u32::from(*bytes)),
            Float => Some(4),
            Array(ty, _) => self.scalar_bytes(ty),
            Struct(number) => {
                let mut sizes = self.unit.structs[*number].members.iter().map(|(_, ty)| self.scalar_bytes(ty));
                let first = sizes.next()??;
                sizes.all(|size| size == Some(first)).then_some(first)
            }
            _ => None,
        }
    }

    fn call(&mut self, name: &'u str, arguments: &'u [Expression]) -> Result<Option<(Value, Type)>, Missing> {
        let function = self.function(name)?;
        let values = arguments.iter().map(|argument| self.value(argument)).collect::<Result<_, _>>()?;
        let place = self.inlined(function, values)?;
        place.map(|place| self.loaded(number(place.address), place.ty)).transpose()
    }

    /// The address of what an expression names, and its type.
    fn place(&mut self, expression: &'u Expression) -> Result<(Value, Type), Missing> {
        match &expression.kind {
            Kind::Name(name) => match self.find(name) {
                Some(place) => Ok((number(place.address), place.ty.clone())),
                None => Err(self.missing(format!("the name `{name}`"))),
            },
            Kind::Unary("*", pointer) => match self.value(pointer)? {
                (address, Pointer(ty)) => Ok((address, *ty)),
                _ => Err(self.missing("a pointer")),
            },
            Kind::Member(structure, name) => {
                let (address, ty) = self.place(structure)?;
                let Struct(structure) = ty else { return Err(self.missing("a structure")) };
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
                let index = self.value(index)?;
                if !index.1.is_integer() {
                    return Err(self.missing("an integer as index"));
                }
                let index = self.converted(index, &Type::UNSIGNED)?;
                let (address, ty, index) = match self.try_place(array)? {
                    Some((address, Array(ty, count))) => {
                        let index = Value::Below(Box::new(index), count);
                        (address, *ty, index)
                    }
                    _ => match self.value(array)? {
                        (address, Pointer(ty)) => (address, *ty, index),
                        _ => return Err(self.missing("an array")),
                    },
                };
                Ok((self.element(address, &ty, index), ty))
            }
            _ => Err(self.missing("something with an address")),
        }
    }

    /// The address of a later element of a type.
    fn element(&self, address: Value, ty: &Type, index: Value) -> Value {
        moved(address, apply(Multiply, Width::W32, index, number(self.cells(ty))))
    }

    fn try_place(&mut self, expression: &'u Expression) -> Result<Option<(Value, Type)>, Missing> {
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
                    Array(ty, _) => Ok((address, Pointer(ty))),
                    ty => self.loaded(address, ty),
                }
            }
            Kind::Unary("&", inner) => {
                let (address, ty) = self.place(inner)?;
                Ok((address, Pointer(Box::new(ty))))
            }
            Kind::Unary("!", _) | Kind::Binary("&&" | "||" | "==" | "!=" | "<" | ">" | "<=" | ">=", ..) => {
                self.truth(expression)
            }
            Kind::Unary(sign, inner) => {
                let (value, ty) = self.value(inner)?;
                match (*sign, &ty) {
                    ("-", Float) => Ok((Value::Negative(Box::new(value)), ty)),
                    ("-", Double) => match value {
                        Value::Float(bits) => Ok((Value::Float(bits ^ 0x8000_0000), ty)),
                        _ => Err(self.missing("arithmetic in binary64")),
                    },
                    ("+", Float | Double) => Ok((value, ty)),
                    ("-" | "~" | "+", Integer(..)) => {
                        let wide = promoted(&ty);
                        let value = self.converted((value, ty), &wide)?;
                        let width = width(&wide);
                        let (operator, first) = match *sign {
                            "-" => (Subtract, 0),
                            "~" => (Xor, width.mask()),
                            _ => (Add, 0),
                        };
                        Ok((apply(operator, width, Value::Number(first), value), wide))
                    }
                    _ => Err(self.missing(format!("`{sign}` of another type"))),
                }
            }
            Kind::Binary(operator, a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.line = expression.line;
                self.operated(operator, a, b)
            }
            Kind::Conditional(condition, a, b) => self.chosen(condition, a, b),
            Kind::Cast(ty, inner) => {
                let value = self.value(inner)?;
                Ok((self.converted(value, ty)?, ty.clone()))
            }
            Kind::Call(name, arguments) => match (name.as_str(), &arguments[..]) {
                ("fabsf", [inner]) => {
                    let value = self.value(inner)?;
                    Ok((Value::Magnitude(Box::new(self.converted(value, &Float)?)), Float))
                }
                ("isnan", [_]) => self.truth(expression),
                _ => self.call(name, arguments)?.ok_or_else(|| self.missing(format!("a result of `{name}`"))),
            },
            Kind::Assign(_, target, _) => {
                self.effect(expression)?;
                self.value(target)
            }
            Kind::Postfix(assignment) => {
                let Kind::Assign(_, target, _) = &assignment.kind else { return self.value(assignment) };
                let (value, ty) = self.value(target)?;
                let cell = self.allocate(&ty);
                self.put(number(cell), (value, ty.clone()), &ty)?;
                self.effect(assignment)?;
                self.loaded(number(cell), ty)
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

    fn chosen(
        &mut self,
        condition: &'u Expression,
        a: &'u Expression,
        b: &'u Expression,
    ) -> Result<(Value, Type), Missing> {
        let condition = self.condition(condition)?;
        let mark = self.here();
        let (first, second) = (self.value(a)?, self.value(b)?);
        let ty = if first.1 == second.1 && !first.1.is_integer() {
            first.1.clone()
        } else {
            self.common(&first.1, &second.1)?
        };
        if self.here() == mark {
            let [first, second] = [self.converted(first, &ty)?, self.converted(second, &ty)?].map(Box::new);
            return Ok((Value::If(Box::new(condition), first, second), ty));
        }
        // something happens on the way: only on the side that is chosen
        self.program.operations.truncate(mark);
        let cell = self.allocate(&ty);
        let branch = self.branch(condition);
        let first = self.value(a)?;
        self.put(number(cell), first, &ty)?;
        let end = self.jump(self.scopes.len());
        self.land(&[branch]);
        let second = self.value(b)?;
        self.put(number(cell), second, &ty)?;
        self.land(&[end]);
        self.loaded(number(cell), ty)
    }

    /// A condition as 0 or 1.
    fn truth(&mut self, expression: &'u Expression) -> Result<(Value, Type), Missing> {
        let condition = self.condition(expression)?;
        Ok((Value::OfCondition(Box::new(condition)), Type::INT))
    }

    /// An expression as a condition.
    pub(super) fn condition(&mut self, expression: &'u Expression) -> Result<Condition, Missing> {
        self.line = expression.line;
        match &expression.kind {
            Kind::Unary("!", inner) => Ok(!self.condition(inner)?),
            Kind::Binary(sign @ ("&&" | "||"), a, b) => {
                let first = self.condition(a)?;
                let mark = self.here();
                let second = self.condition(b)?;
                if self.here() != mark {
                    // what happens in the second operand happens only if the first asks for it
                    self.program.operations.truncate(mark);
                    return self.lazily(*sign == "&&", first, b);
                }
                Ok(Logical(*sign == "&&", Box::new(first), Box::new(second)))
            }
            Kind::Binary(sign @ ("==" | "!=" | "<" | ">" | "<=" | ">="), a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.line = expression.line;
                self.compared(sign, a, b)
            }
            Kind::Call(name, arguments) if name == "isnan" && arguments.len() == 1 => {
                let value = self.value(&arguments[0])?;
                Ok(Nan(self.converted(value, &Float)?))
            }
            _ => {
                let (value, ty) = self.value(expression)?;
                match ty {
                    Integer(..) => Ok(!Same(width(&ty), value, number(0))),
                    Float => Ok(!Compared(Terms::equal, value, Value::Float(0))),
                    _ => Err(self.missing("a condition of another type")),
                }
            }
        }
    }

    fn lazily(&mut self, and: bool, first: Condition, second: &'u Expression) -> Result<Condition, Missing> {
        let cell = self.allocate(&Type::INT);
        self.emit(Operation::Set(number(cell), number(u32::from(!and))));
        let branch = self.branch(if and { first } else { !first });
        let second = self.condition(second)?;
        self.emit(Operation::Set(number(cell), Value::OfCondition(Box::new(second))));
        self.land(&[branch]);
        Ok(!Same(Width::W32, self.loaded(number(cell), Type::INT)?.0, number(0)))
    }

    fn compared(&mut self, sign: &str, a: (Value, Type), b: (Value, Type)) -> Result<Condition, Missing> {
        let ty = self.common(&a.1, &b.1)?;
        let (mut a, mut b) = (self.converted(a, &ty)?, self.converted(b, &ty)?);
        if sign.starts_with('>') {
            (a, b) = (b, a);
        }
        let (width, signed) = (width(&ty), ty != Type::UNSIGNED && ty != Integer(8, false));
        let condition = match (&ty, sign) {
            (Float, "==" | "!=") => Compared(Terms::equal, a, b),
            (Float, "<" | ">") => Compared(Terms::less, a, b),
            (Float, _) => Compared(Terms::less_or_equal, a, b),
            (_, "==" | "!=") => Same(width, a, b),
            (_, "<" | ">") => Below(signed, width, a, b),
            _ => !Below(signed, width, b, a),
        };
        Ok(if sign == "!=" { !condition } else { condition })
    }

    fn operated(&mut self, sign: &str, a: (Value, Type), b: (Value, Type)) -> Result<(Value, Type), Missing> {
        if let (Pointer(ty), "+", Integer(..)) = (&a.1, sign, &b.1) {
            let index = self.converted(b, &Type::UNSIGNED)?;
            return Ok((self.element(a.0, ty, index), a.1.clone()));
        }
        let shifts = matches!(sign, "<<" | ">>");
        let ty = if shifts { promoted(&a.1) } else { self.common(&a.1, &b.1)? };
        let (a, b) = (self.converted(a, &ty)?, self.converted(b, if shifts { &Type::UNSIGNED } else { &ty })?);
        if ty == Float {
            let (operation, b) = match sign {
                "+" => (Arithmetic::Add, b),
                "-" => (Arithmetic::Add, Value::Negative(Box::new(b))),
                "*" => (Arithmetic::Multiply, b),
                "/" => (Arithmetic::Divide, b),
                _ => return Err(self.missing(format!("`{sign}` of floats"))),
            };
            return Ok((Value::Arithmetic(operation, Box::new(a), Box::new(b)), ty));
        }
        let Integer(_, signed) = ty else { return Err(self.missing(format!("`{sign}` of this type"))) };
        let operator = match sign {
            "+" => Add,
            "-" => Subtract,
            "*" => Multiply,
            "/" if !signed => Divide,
            "%" if !signed => Modulo,
            "&" => And,
            "|" => Or,
            "^" => Xor,
            "<<" => ShiftLeft,
            ">>" if signed => ShiftArithmetic,
            ">>" => ShiftRight,
            _ => return Err(self.missing(format!("`{sign}` of signed integers"))),
        };
        Ok((apply(operator, width(&ty), a, b), ty))
    }

    /// The type in which two operands are computed with.
    fn common(&self, x: &Type, y: &Type) -> Result<Type, Missing> {
        match (promoted(x), promoted(y)) {
            (Double, _) | (_, Double) => Err(self.missing("arithmetic in binary64")),
            (Float, Float | Integer(..)) | (Integer(..), Float) => Ok(Float),
            // the wider one, or unsigned if either of the same size is
            (Integer(a, s), Integer(b, t)) => Ok(Integer(
                a.max(b),
                if a == b {
                    s && t
                } else if a > b {
                    s
                } else {
                    t
                },
            )),
            _ => Err(self.missing("operands of another type")),
        }
    }

    pub(super) fn converted(&self, (value, from): (Value, Type), to: &Type) -> Result<Value, Missing> {
        let apply = |operator, width, a, b| apply(operator, width, a, Value::Number(b));
        match (&from, to) {
            _ if from == *to => Ok(value),
            (Pointer(_), Pointer(_)) | (_, Void) => Ok(value),
            // a constant of the wider type: it is rounded once more
            (Double, Float) if matches!(value, Value::Float(_)) => Ok(value),
            (Integer(bytes, signed), Float) if *bytes <= 4 => Ok(Value::OfInteger(*signed, Box::new(value))),
            (Float, Integer(..)) => Err(self.missing("a float that is in the range of an integer")),
            (Integer(a, signed), Integer(b, to_signed)) => Ok(match (a, b) {
                (8, 8) => value,
                (_, 8) if *signed => {
                    let flipped = apply(Xor, Width::W64, value, 0x8000_0000);
                    apply(Subtract, Width::W64, flipped, 0x8000_0000)
                }
                (_, 8) => value,
                (8, _) | (_, 1 | 2) if *to_signed && *b < 4 => {
                    let unused = 32 - 8 * u64::from(*b);
                    let upper = apply(ShiftLeft, Width::W32, value, unused);
                    apply(ShiftArithmetic, Width::W32, upper, unused)
                }
                (8, _) | (_, 1 | 2) => {
                    let width = if *a == 8 { Width::W64 } else { Width::W32 };
                    apply(And, width, value, (1 << (8 * u64::from(*b))) - 1)
                }
                _ => value,
            }),
            _ => Err(self.missing(format!("a conversion from {from:?} to {to:?}"))),
        }
    }
}
