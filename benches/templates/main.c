/* Decides all states of a file, and says how long it took: see tpg-benches' program. */
#define _POSIX_C_SOURCE 199309L

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
{% if rust %}
typedef struct timed_state {
    {{ scalar }} values[{{ length }}];
} timed_state_t;

extern uint16_t timed_infer(const timed_state_t *state);
{% else %}
#include "timed.h"
{% endif %}
{%- if gegelati %}
typedef struct timed_state {
{%- for (name, length) in sources %}
    {{ scalar }} {{ name }}[{{ length }}];
{%- endfor %}
} timed_state_t;

{% for _ in sources %}
{{ scalar }} *in{{ loop.index }};
{%- endfor %}
{% endif %}
#define STATES {{ count }}U

typedef char no_padding[(sizeof(timed_state_t) == ({{ length }}U * sizeof({{ scalar }}))) ? 1 : -1];

static timed_state_t states[STATES];

/* A hash of the actions of the first states: work that no compiler can leave out. */
static uint32_t pass(uint32_t count)
{
    uint32_t hash = 2166136261U;
    uint32_t index;

    for (index = 0U; index < count; index++) {
        uint32_t action;
{% if gegelati %}
{%- for (name, _) in sources %}
        in{{ loop.index }} = states[index].{{ name }};
{%- endfor %}
        action = (uint32_t)inferenceTPG();
{%- else %}
        action = timed_infer(&states[index]);
{%- endif %}
        hash = (hash ^ action) * 16777619U;
    }
    return hash;
}

static double nanoseconds(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return ((double)now.tv_sec * 1e9) + (double)now.tv_nsec;
}

int main(int argc, char **argv)
{
    FILE *file = (argc > 1) ? fopen(argv[1], "rb") : NULL;
    unsigned long passes;

    if ((file == NULL) || (fread(states, sizeof(states[0]), STATES, file) != STATES)) {
        return 1;
    }
    (void)fclose(file);
    if (argc > 3) {
        const uint32_t count = (uint32_t)strtoul(argv[3], NULL, 10);

        for (passes = strtoul(argv[2], NULL, 10); passes > 0U; passes--) {
            (void)printf("%lu\n", (unsigned long)pass(count));
        }
        return 0;
    }
    while (scanf("%lu", &passes) == 1) {
        const double start = nanoseconds();
        unsigned long done;
        uint32_t hash = 0U;

        for (done = 0U; done < passes; done++) {
            hash = pass(STATES);
        }
        (void)printf("%.0f %lu\n", nanoseconds() - start, (unsigned long)hash);
        (void)fflush(stdout);
    }
    return 0;
}
