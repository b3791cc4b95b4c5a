{% if inlined %}
#ifdef __GNUC__
#define {{ upper }}_INLINE static inline __attribute__((always_inline)) /* at -Os, too: a call takes as long as what it does */
#else
#define {{ upper }}_INLINE static inline
#endif
{% endif %}

/* A mask that chooses, hidden from the optimiser: where it knows that a mask is a sign, it may make a condition of it. */
{{ storage }} {{ key }} {{ prefix }}_opaque({{ key }} mask)
{
#if defined(__GNUC__) && !defined(__FRAMAC__)
    {{ key }} hidden = mask;

    __asm__("" : "+r"(hidden));
    return hidden;
#else
    return mask;
#endif
}

/* a where the mask is all ones, b where it is 0. */
{{ storage }} {{ scalar }} {{ prefix }}_select({{ key }} mask, {{ scalar }} a, {{ scalar }} b)
{
    {{ key }} bits_a;
    {{ key }} bits_b;
    {{ scalar }} result;
    (void)memcpy(&bits_a, &a, sizeof bits_a);
    (void)memcpy(&bits_b, &b, sizeof bits_b);
    bits_b ^= (bits_a ^ bits_b) & mask;
    (void)memcpy(&result, &bits_b, sizeof result);
    return result;
}

/* All ones where a > b, else 0; NaN is above nothing. The difference is positive: its bits, less 1, are below infinity's. */
{{ storage }} {{ key }} {{ prefix }}_above({{ scalar }} a, {{ scalar }} b)
{
    const {{ scalar }} difference = a - b;
    {{ key }} bits;
    (void)memcpy(&bits, &difference, sizeof bits);
    bits -= 1U;
    return {{ prefix }}_opaque(0U - (((bits - {{ infinity }}) & ~bits) >> {{ top }}));
}

/* All ones where x is NaN, else 0: its bits are above infinity's. */
{{ storage }} {{ key }} {{ prefix }}_not_a_number({{ scalar }} x)
{
    {{ key }} bits;
    (void)memcpy(&bits, &x, sizeof bits);
    return {{ prefix }}_opaque(0U - (({{ infinity }} - (bits & ~{{ sign }})) >> {{ top }}));
}

{{ storage }} {{ scalar }} {{ prefix }}_negate_if_less({{ scalar }} a, {{ scalar }} b)
{
    const {{ key }} less = {{ prefix }}_above(b, a);
    {{ key }} bits;
    {{ scalar }} result;
    (void)memcpy(&bits, &a, sizeof bits);
    bits ^= less & {{ sign }};
    (void)memcpy(&result, &bits, sizeof result);
    return result;
}

{{ storage }} {{ scalar }} {{ prefix }}_min({{ scalar }} a, {{ scalar }} b)
{
    return {{ prefix }}_select({{ prefix }}_above(b, a), a, b);
}

{{ storage }} {{ scalar }} {{ prefix }}_max({{ scalar }} a, {{ scalar }} b)
{
    return {{ prefix }}_select({{ prefix }}_above(a, b), a, b);
}

/* a where b is not 0, else -0. */
{{ storage }} {{ scalar }} {{ prefix }}_gate({{ scalar }} a, {{ scalar }} b)
{
    {{ key }} bits;
    (void)memcpy(&bits, &b, sizeof bits);
    return {{ prefix }}_select({{ prefix }}_opaque(0U - (((bits & ~{{ sign }}) - 1U) >> {{ top }})), -{{ zero }}, a);
}

/* a / b, rounded down. By 0, the greatest integer with the sign of a, and of 0 / 0 the lowest. */
{{ storage }} {{ scalar }} {{ prefix }}_quotient({{ scalar }} a, {{ scalar }} b)
{
    const {{ scalar }} quotient = a / b;
    const {{ scalar }} not_positive = {{ prefix }}_select({{ prefix }}_above({{ zero }}, a), {{ by_zero[1] }}, {{ by_zero[2] }});
    const {{ scalar }} by_zero = {{ prefix }}_select({{ prefix }}_above(a, {{ zero }}), {{ by_zero[0] }}, not_positive);
    {{ key }} bits;
    {{ key }} small;
    {{ scalar }} within;
    {{ scalar }} whole;
    (void)memcpy(&bits, &quotient, sizeof bits);
    small = {{ prefix }}_opaque(0U - (((bits & ~{{ sign }}) - {{ most_bits }}) >> {{ top }})); /* from there on, all are whole */
    within = {{ prefix }}_select(small, quotient, {{ zero }});
    whole = ({{ scalar }})({{ signed }})within;
    whole = whole - {{ prefix }}_select({{ prefix }}_above(whole, within), {{ one }}, {{ zero }});
    whole = {{ prefix }}_select(small, whole, quotient);
    (void)memcpy(&bits, &b, sizeof bits);
    return {{ prefix }}_select({{ prefix }}_opaque(0U - (((bits & ~{{ sign }}) - 1U) >> {{ top }})), by_zero, whole);
}

/* The square root of the magnitude, which no compiler tests; NaN of a negative number. */
{{ storage }} {{ scalar }} {{ prefix }}_sqrt({{ scalar }} x)
{
    const {{ scalar }} root = {{ printer.root() }}({{ printer.function("fabs") }}(x));
    {{ key }} bits;
    {{ key }} bits_of_root;
    {{ scalar }} result;
    (void)memcpy(&bits, &x, sizeof bits);
    (void)memcpy(&bits_of_root, &root, sizeof bits_of_root);
    bits_of_root |= bits & {{ sign }};
    bits_of_root |= {{ prefix }}_opaque(0U - ((({{ sign }} - bits) & bits) >> {{ top }})) & ~{{ sign }}; /* beyond -0 */
    (void)memcpy(&result, &bits_of_root, sizeof result);
    return result;
}

/* All ones where x has a sign, else 0. */
{{ storage }} {{ key }} {{ prefix }}_negative({{ scalar }} x)
{
    {{ key }} bits;
    (void)memcpy(&bits, &x, sizeof bits);
    return {{ prefix }}_opaque(0U - (bits >> {{ top }}));
}

/* An output in its range. */
{{ storage }} {{ scalar }} {{ prefix }}_clamp({{ scalar }} value, {{ scalar }} low, {{ scalar }} high{% if same_nan.is_none() %}, {{ scalar }} nan{% endif %})
{
    /* Differences of what is equal are 0, not -0; where the value is NaN, both choices are of no account. */
    const {{ scalar }} unsigned_zero = value + {{ zero }};
    const {{ scalar }} raised = {{ prefix }}_select({{ prefix }}_negative(unsigned_zero - low), low, value);
    const {{ scalar }} limited = {{ prefix }}_select({{ prefix }}_negative((high + {{ zero }}) - unsigned_zero), high, raised);
    return {{ prefix }}_select({{ prefix }}_not_a_number(value), {% if let Some(nan) = same_nan %}{{ nan }}{% else %}nan{% endif %}, limited);
}

/* The candidate where the numbers are equal, else the value. */
{{ storage }} {{ scalar }} {{ prefix }}_pick(uint32_t leaf, uint32_t number, {{ scalar }} candidate, {{ scalar }} value)
{
    const uint32_t different = leaf ^ number;
    const {{ key }} mask = ({{ key }})((different | (0U - different)) >> 31);
    return {{ prefix }}_select({{ prefix }}_opaque(mask - 1U), candidate, value);
}

/* A bid that can be compared: minus infinity for NaN. */
{{ storage }} {{ scalar }} {{ prefix }}_number({{ scalar }} bid)
{
    const {{ key }} unordered = {{ prefix }}_not_a_number(bid);
    {{ key }} bits;
    {{ scalar }} result;
    (void)memcpy(&bits, &bid, sizeof bits);
    bits = (bits | unordered) & ~(unordered >> {{ exponent_end }}); /* ones down to the exponent's last */
    (void)memcpy(&result, &bits, sizeof result);
    return result;
}

/* Lets a bid win where it is as high as the best so far, or that is NaN. */
{{ storage }} void {{ prefix }}_challenge({{ scalar }} *best, uint32_t *to, {{ scalar }} bid, uint32_t destination)
{
    const {{ key }} lower = {{ prefix }}_above(*best, bid);
    const uint32_t mask = (uint32_t)lower;
    *best = {{ prefix }}_select(lower, *best, bid);
    *to = destination ^ ((destination ^ *to) & mask);
}

