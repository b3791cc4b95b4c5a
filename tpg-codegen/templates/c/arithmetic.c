/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t {{ prefix }}_arithmetic(void)
{
{%- if f64 %}
    const volatile double numbers[6] = { 0.0, DBL_MAX, 1.0000000074505806, 9007199254740992.0, 49.0, DBL_MIN };
{%- else %}
    const volatile float numbers[6] = { 0.0f, FLT_MAX, 1.0002441f, 16777216.0f, 41.0f, FLT_MIN };
{%- endif %}
    const {{ scalar }} zero = numbers[0];
    const {{ scalar }} most = numbers[1];
    const {{ scalar }} near_one = numbers[2];
    const {{ scalar }} large = numbers[3];
    const {{ scalar }} dividend = numbers[4];
    const {{ scalar }} smallest = numbers[5];
    const {{ scalar }} infinite = most + most;
    const {{ scalar }} nan = infinite * zero;
    const {{ scalar }} fused = (near_one * near_one) - {% if f64 %}1.0000000149011612{% else %}1.0004883f{% endif %};
    const {{ scalar }} reordered = (large + {% if f64 %}1.0{% else %}1.0f{% endif %}) - large;
    const {{ scalar }} quotient = dividend / {% if f64 %}49.0{% else %}41.0f{% endif %};
    uint32_t wrong = 0U;

    wrong += ((nan >= zero) || (nan <= zero)) ? 1U : 0U;
    wrong += (infinite > {% if f64 %}DBL_MAX{% else %}FLT_MAX{% endif %}) ? 0U : 1U;
    wrong += (fused > zero) ? 1U : 0U;
    wrong += (reordered > zero) ? 1U : 0U;
    wrong += (quotient < {% if f64 %}1.0{% else %}1.0f{% endif %}) ? 1U : 0U;
    wrong += ((smallest * {% if f64 %}0.5{% else %}0.5f{% endif %}) > zero) ? 0U : 1U;
    return wrong;
}
