
/* Compiled for size, comparisons of doubles stand once: on many processors each is a call. */
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define {{ upper }}_LEADER static __attribute__((noinline))
#elif defined(__GNUC__)
#define {{ upper }}_LEADER static inline __attribute__((always_inline))
#else
#define {{ upper }}_LEADER static inline
#endif

/* Who leads a team: its bid, and the edge or way it stands for. */
typedef struct {{ prefix }}_lead {
    {{ scalar }} best;
{%- if near %}
    {{ scalar }} top; /* who leads bids from best to this, if that has not been computed */
    uint32_t late; /* 1 where it has not */
{%- endif %}
    uint32_t winner;
} {{ prefix }}_lead_t;
{% if takes %}

/* Lets a bid of a later edge than the others lead if none is higher. */
{{ upper }}_LEADER void {{ prefix }}_take({{ prefix }}_lead_t *lead, {{ scalar }} bid, uint32_t winner)
{
    if (bid >= lead->best) {
        lead->best = bid;
        lead->winner = winner;
    }
}
{% endif %}
{% if takes_at %}

/* Lets a bid lead if none is higher; of equal bids the later edge leads. */
{{ upper }}_LEADER void {{ prefix }}_take_at({{ prefix }}_lead_t *lead, {{ scalar }} bid, uint32_t winner)
{
    if ((bid >= lead->best) && ((bid > lead->best) || (lead->winner < winner))) {
        lead->best = bid;
        lead->winner = winner;
    }
}
{% endif %}
{% if can %}

/* Tests whether a bid of a later edge than the others can lead; also where the bound is NaN and says nothing. */
{{ upper }}_LEADER uint32_t {{ prefix }}_can(const {{ prefix }}_lead_t *lead, {{ scalar }} bound)
{
    return (lead->best > bound) ? 0U : 1U;
}
{% endif %}
{% if can_at %}

/* The same for a bid of any edge. */
{{ upper }}_LEADER uint32_t {{ prefix }}_can_at(const {{ prefix }}_lead_t *lead, {{ scalar }} bound, uint32_t winner)
{
    return ((lead->best > bound) || ((lead->best >= bound) && (lead->winner >= winner))) ? 0U : 1U;
}
{% endif %}
{% if near %}

/* Lets a bid that is from low to high lead, where it is certain to; 1 where that depends on what it is. */
{{ upper }}_LEADER uint32_t {{ prefix }}_near({{ prefix }}_lead_t *lead, {{ scalar }} low, {{ scalar }} high, uint32_t winner)
{
    uint32_t is_near = {{ prefix }}_can_at(lead, high, winner);

    if (is_near != 0U) {
        const {{ scalar }} top = (lead->late != 0U) ? lead->top : lead->best;

        if ((low >= top) && ((low > top) || (lead->winner < winner))) {
            lead->best = low;
            lead->top = high;
            lead->late = 1U;
            lead->winner = winner;
            is_near = 0U;
        }
    }
    return is_near;
}
{% for estimate in estimates %}

{{ upper }}_LEADER uint32_t {{ prefix }}_{{ estimate.name }}_near({{ prefix }}_lead_t *lead, {{ scalar }} argument, uint32_t winner)
{
    uint32_t is_near = 0U;

    if (!((argument <= {{ estimate.at_most }}) && (lead->best >= {{ estimate.below }}))) {
        const {{ scalar }} high = {{ prefix }}_{{ estimate.name }}_upper(argument);

        is_near = {{ prefix }}_near(lead, {{ estimate.low }}, high, winner);
    }
    return is_near;
}
{% endfor %}
{% endif %}
