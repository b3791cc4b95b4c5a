{%- for (int, bits) in [("i32", ""), ("i64", "_64")] %}

/// a / b, rounded down, of a b that is not 0.
fn divide{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    // Not the operator, which could panic as far as the compiler knows.
    let quotient = a.checked_div(b).unwrap_or(0);
    if quotient * b != a && (a < 0) != (b < 0) { quotient - 1 } else { quotient }
}

/// a / b, rounded down. By 0, the greatest integer with the sign of a, and of 0 / 0 the lowest: as a bid, it loses.
fn quotient{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    match (b, a.signum()) {
        (0, 1) => 2147483647,
        (0, 0) => -2147483648,
        (0, _) => -2147483647,
        _ => divide{{ bits }}(a, b),
    }
}

fn negate_if_less{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    if a < b { -a } else { a }
}

fn gate{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    if b != 0 { a } else { 0 }
}

{% endfor %}
