{% if branch_free && !f64 %}
/* All ones where the top bit is set, else 0. */
static uint32_t {{ prefix }}_fmod_mask(uint32_t bits)
{
    return {{ prefix }}_opaque(0U - (bits >> 31));
}

/* a where the mask is all ones, b where it is 0. */
static uint32_t {{ prefix }}_fmod_choose(uint32_t mask, uint32_t a, uint32_t b)
{
    return b ^ ((a ^ b) & mask);
}

/* The bits of a magnitude, scaled by 2^24 where the mask says that it is subnormal. */
static uint32_t {{ prefix }}_fmod_normal(uint32_t magnitude, uint32_t subnormal)
{
    float x;
    uint32_t scaled;
    (void)memcpy(&x, &magnitude, sizeof x);
    x = x * 16777216.0f;
    (void)memcpy(&scaled, &x, sizeof scaled);
    return {{ prefix }}_fmod_choose(subnormal, scaled, magnitude);
}

/* Up to 8 bits of what is left. */
static uint32_t {{ prefix }}_fmod_step(uint32_t rest, uint32_t *left, uint32_t modulus)
{
    const uint32_t bits = {{ prefix }}_fmod_choose({{ prefix }}_fmod_mask(*left - 8U), *left, 8U);
    *left -= bits;
    return (rest << bits) % modulus;
}

static uint32_t {{ prefix }}_fmod_seven_steps(uint32_t before, uint32_t *left, uint32_t modulus)
{
    uint32_t rest = before;
    rest = {{ prefix }}_fmod_step(rest, left, modulus);
    rest = {{ prefix }}_fmod_step(rest, left, modulus);
    rest = {{ prefix }}_fmod_step(rest, left, modulus);
    rest = {{ prefix }}_fmod_step(rest, left, modulus);
    rest = {{ prefix }}_fmod_step(rest, left, modulus);
    rest = {{ prefix }}_fmod_step(rest, left, modulus);
    rest = {{ prefix }}_fmod_step(rest, left, modulus);
    return rest;
}

/* The steps of all divisions: those of the farthest exponents there are. */
static uint32_t {{ prefix }}_fmod_rest(uint32_t integer, uint32_t steps, uint32_t modulus)
{
    uint32_t left = steps;
    uint32_t rest = {{ prefix }}_fmod_seven_steps(integer, &left, modulus);
    rest = {{ prefix }}_fmod_seven_steps(rest, &left, modulus);
    rest = {{ prefix }}_fmod_seven_steps(rest, &left, modulus);
    rest = {{ prefix }}_fmod_seven_steps(rest, &left, modulus);
    rest = {{ prefix }}_fmod_seven_steps(rest, &left, modulus);
    return rest;
}

/* The bits of the remainder of a / b, both positive, exactly: a number is an integer times a power of two. */
static uint32_t {{ prefix }}_fmod_magnitude(uint32_t a, uint32_t b)
{
    const uint32_t small_a = {{ prefix }}_fmod_mask(a - 0x00800000U);
    const uint32_t small_b = {{ prefix }}_fmod_mask(b - 0x00800000U);
    const uint32_t normal_a = {{ prefix }}_fmod_normal(a, small_a);
    const uint32_t normal_b = {{ prefix }}_fmod_normal(b, small_b);
    const uint32_t modulus = (normal_b & 0x007fffffU) | 0x00800000U;
    const uint32_t scaled_down = 24U & small_b;
    const uint32_t above = ((normal_a >> 23) - (24U & small_a)) - ((normal_b >> 23) - scaled_down);
    const uint32_t left = above & ~{{ prefix }}_fmod_mask(above);
    const uint32_t rest = {{ prefix }}_fmod_rest((normal_a & 0x007fffffU) | 0x00800000U, left, modulus);
    const uint32_t power_bits = normal_b & 0x7f800000U;
    const uint32_t scale_bits = (127U - scaled_down) << 23;
    uint32_t bits;
    float power;
    float scale;
    float value;

    /* the products are exact */
    (void)memcpy(&power, &power_bits, sizeof power);
    (void)memcpy(&scale, &scale_bits, sizeof scale);
    value = (float)rest * FLT_EPSILON;
    value = value * power;
    value = value * scale;
    (void)memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* The remainder of a / b with the sign of a. */
static float {{ prefix }}_fmod(float a, float b)
{
    uint32_t bits;
    uint32_t divisor;
    uint32_t dividend;
    uint32_t result;
    uint32_t nan;
    float value;

    (void)memcpy(&bits, &a, sizeof bits);
    (void)memcpy(&divisor, &b, sizeof divisor);
    divisor &= 0x7fffffffU;
    dividend = bits & 0x7fffffffU;
    result = {{ prefix }}_fmod_magnitude(dividend, divisor) | (bits & 0x80000000U);
    result = {{ prefix }}_fmod_choose({{ prefix }}_fmod_mask(dividend - divisor), bits, result);

    /* a is infinite, b is no number, or 0 */
    nan = {{ prefix }}_fmod_mask(0x7f7fffffU - dividend) | {{ prefix }}_fmod_mask(0x7f800000U - divisor);
    nan |= {{ prefix }}_fmod_mask(divisor - 1U);
    result |= 0x7fc00000U & nan;
    (void)memcpy(&value, &result, sizeof value);
    return value;
}
{% else %}
/* The remainder of a / b with the sign of a, exactly: a number is an integer times a power of two. */
static {{ scalar }} {{ prefix }}_fmod({{ scalar }} a, {{ scalar }} b)
{
{%- if f64 %}
    const uint64_t least_normal = 0x0010000000000000ULL;
    const uint32_t most = 11U; /* bits of a step: what is left, shifted by them, fits 64 bits */
    const uint32_t fraction = 52U;
{%- else %}
    const uint32_t least_normal = 0x00800000U;
    const uint32_t most = 8U; /* bits of a step: what is left, shifted by them, fits 32 bits */
    const uint32_t fraction = 23U;
{%- endif %}
    {{ key }} dividend;
    {{ key }} divisor;
    {{ scalar }} result = a;

    (void)memcpy(&dividend, &a, sizeof dividend);
    (void)memcpy(&divisor, &b, sizeof divisor);
    dividend &= ~{{ sign }};
    divisor &= ~{{ sign }};
    if ((dividend >= {{ infinity }}) || (divisor > {{ infinity }}) || (divisor == 0U)) {
        result = {% if f64 %}(double)NAN{% else %}NAN{% endif %};
    } else if (dividend >= divisor) {
        const {{ key }} from = (dividend < least_normal) ? 1U : (dividend >> fraction);
        const {{ key }} to = (divisor < least_normal) ? 1U : (divisor >> fraction);
        const {{ key }} integer = (dividend & (least_normal - 1U)) | ((dividend < least_normal) ? 0U : least_normal);
        const {{ key }} modulus = (divisor & (least_normal - 1U)) | ((divisor < least_normal) ? 0U : least_normal);
        const {{ key }} power_bits = to << fraction;
        uint32_t left = (uint32_t)(from - to);
        {{ key }} rest = integer % modulus;
        {{ scalar }} power;

        while (left > 0U) {
            const uint32_t step = (left < most) ? left : most;
            rest = (rest << step) % modulus;
            left -= step;
        }
        /* both products are exact */
        (void)memcpy(&power, &power_bits, sizeof power);
        result = ({{ scalar }})rest * {% if f64 %}DBL_EPSILON{% else %}FLT_EPSILON{% endif %};
        result = result * power;
        result = (a < {% if f64 %}0.0{% else %}0.0f{% endif %}) ? -result : result;
    } else {
        /* no change */
    }
    return result;
}
{% endif %}
