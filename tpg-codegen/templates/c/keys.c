{% if chooses %}
/* A mask that chooses, hidden from the optimiser: where it knows that a mask is a sign, it may make a condition of it. */
static {{ key }} {{ prefix }}_opaque({{ key }} mask)
{
#if defined(__GNUC__) && !defined(__FRAMAC__)
    {{ key }} hidden = mask;

    __asm__("" : "+r"(hidden));
    return hidden;
#else
    return mask;
#endif
}
{% endif %}
{% if orders %}

static {{ key }} {{ prefix }}_order({{ scalar }} x)
{
    /* 0 for -0; then, as integers: what is negative upside down, below what is positive */
    const {{ scalar }} sum = x + {% if f64 %}0.0{% else %}0.0F{% endif %};
    {{ key }} bits;
    (void)memcpy(&bits, &sum, sizeof bits);
    return bits ^ ((0U - (bits >> {{ top }})) | {{ sign }});
}

/* All ones where a < b, else 0: the borrow of a - b. */
static {{ key }} {{ prefix }}_below({{ key }} a, {{ key }} b)
{
    return 0U - (((~a & b) | (~(a ^ b) & (a - b))) >> {{ top }});
}

/* All ones where x is NaN, whose key is beyond those of the infinities. */
static {{ key }} {{ prefix }}_not_a_number({{ key }} order)
{
    return {{ prefix }}_below(order, {{ minus_infinity }}) | {{ prefix }}_below({{ infinity }}, order);
}
{% endif %}
{% if compares %}

/* All ones where a < b, else 0; NaN is below nothing. */
static {{ key }} {{ prefix }}_less({{ scalar }} a, {{ scalar }} b)
{
    const {{ key }} order_a = {{ prefix }}_order(a);
    const {{ key }} order_b = {{ prefix }}_order(b);
    const {{ key }} unordered = {{ prefix }}_not_a_number(order_a) | {{ prefix }}_not_a_number(order_b);
    return {{ prefix }}_below(order_a, order_b) & ~unordered;
}
{% endif %}
{% if selects %}

/* a where the mask is all ones, b where it is 0. */
static {{ scalar }} {{ prefix }}_select({{ key }} mask, {{ scalar }} a, {{ scalar }} b)
{
    {{ key }} bits_a;
    {{ key }} bits_b;
    {{ scalar }} result;
    (void)memcpy(&bits_a, &a, sizeof bits_a);
    (void)memcpy(&bits_b, &b, sizeof bits_b);
    bits_b ^= (bits_a ^ bits_b) & {{ prefix }}_opaque(mask);
    (void)memcpy(&result, &bits_b, sizeof result);
    return result;
}
{% endif %}
{% if uses_negate_if_less %}

static {{ scalar }} {{ prefix }}_negate_if_less({{ scalar }} a, {{ scalar }} b)
{
    const {{ key }} less = {{ prefix }}_opaque({{ prefix }}_less(a, b));
    {{ key }} bits;
    {{ scalar }} result;
    (void)memcpy(&bits, &a, sizeof bits);
    bits ^= less & {{ sign }};
    (void)memcpy(&result, &bits, sizeof result);
    return result;
}
{% endif %}
{% if uses_min %}

static {{ scalar }} {{ prefix }}_min({{ scalar }} a, {{ scalar }} b)
{
    return {{ prefix }}_select({{ prefix }}_less(a, b), a, b);
}
{% endif %}
{% if uses_max %}

static {{ scalar }} {{ prefix }}_max({{ scalar }} a, {{ scalar }} b)
{
    return {{ prefix }}_select({{ prefix }}_less(b, a), a, b);
}
{% endif %}
{% if uses_gate %}

/* a where b is not 0, else -0. */
static {{ scalar }} {{ prefix }}_gate({{ scalar }} a, {{ scalar }} b)
{
    {{ key }} bits;
    (void)memcpy(&bits, &b, sizeof bits);
    return {{ prefix }}_select(0U - (((bits & ~{{ sign }}) - 1U) >> {{ top }}), {% if f64 %}-0.0{% else %}-0.0F{% endif %}, a);
}
{% endif %}
{% if clamps %}

/* An output in its range. */
static {{ scalar }} {{ prefix }}_clamp({{ scalar }} value, {{ scalar }} low, {{ scalar }} high, {{ scalar }} nan)
{
    const {{ key }} order = {{ prefix }}_order(value);
    const {{ scalar }} raised = {{ prefix }}_select({{ prefix }}_below(order, {{ prefix }}_order(low)), low, value);
    const {{ scalar }} limited = {{ prefix }}_select({{ prefix }}_below({{ prefix }}_order(high), order), high, raised);
    return {{ prefix }}_select({{ prefix }}_not_a_number(order), nan, limited);
}
{% endif %}
{% if picks %}

/* The candidate where the numbers are equal, else the value. */
static {{ scalar }} {{ prefix }}_pick(uint32_t leaf, uint32_t number, {{ scalar }} candidate, {{ scalar }} value)
{
    const uint32_t different = leaf ^ number;
    const {{ key }} mask = ({{ key }})((different | (0U - different)) >> 31);
    return {{ prefix }}_select(mask - 1U, candidate, value);
}
{% endif %}
{% if decides %}

/* A bid as an integer in the order of bids: a NaN counts as minus infinity. */
static {{ key }} {{ prefix }}_key({{ scalar }} bid)
{
    const {{ key }} order = {{ prefix }}_order(bid);
    const {{ key }} unordered = {{ prefix }}_not_a_number(order);
    return (order & ~unordered) | ({{ minus_infinity }} & unordered);
}

/* Lets a bid win where it is as high as the best so far. */
static void {{ prefix }}_challenge({{ key }} *best, uint32_t *to, {{ key }} bid, uint32_t destination)
{
    const {{ key }} lower = {{ prefix }}_opaque({{ prefix }}_below(bid, *best));
    const uint32_t mask = (uint32_t)lower;
    *best = bid ^ ((bid ^ *best) & lower);
    *to = destination ^ ((destination ^ *to) & mask);
}
{% endif %}
