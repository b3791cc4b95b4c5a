{% for helper in helpers %}
{%- let (int, bits) = (helper.int, helper.end) %}
{% if helper.calls(Function::Divide) %}
/// a / b, rounded down, of a b that is not 0.
fn divide{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    // Not the operator, which could panic as far as the compiler knows.
    let quotient = a.checked_div(b).unwrap_or(0);
    if quotient * b != a && (a < 0) != (b < 0) { quotient - 1 } else { quotient }
}
{% endif %}
{% if helper.calls(Function::Quotient) %}
/// a / b, rounded down. By 0, the greatest integer with the sign of a, and of 0 / 0 the lowest: as a bid, it loses.
fn quotient{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    match (b, a.signum()) {
        (0, 1) => 2147483647,
        (0, 0) => -2147483648,
        (0, _) => -2147483647,
        _ => divide{{ bits }}(a, b),
    }
}
{% endif %}
{% if helper.calls(Function::NegateIfLess) %}
fn negate_if_less{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    if a < b { -a } else { a }
}
{% endif %}
{% if helper.calls(Function::Gate) %}
fn gate{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    if b != 0 { a } else { 0 }
}
{% endif %}
{% endfor %}
