/* Instructions of every profile of a policy on the same states. */
#include "platform.h"
#include "report.h"
#include "under_test.h"

#include <stdint.h>

typedef uint16_t (*infer_t)(const void *state);

#define INFER(name)                                                                                                    \
    static uint16_t name(const void *state)                                                                            \
    {                                                                                                                  \
        return p_##name##_infer(state);                                                                                \
    }

INFER(fast)
INFER(balanced)
INFER(small)
INFER(constant)

static const struct {
    const char *words;
    infer_t infer;
} policies[] = {
    { "cost fast", fast },
    { "cost balanced", balanced },
    { "cost small", small },
    { "cost constant", constant },
};

/* A call that does nothing: what counting and calling cost. */
static uint16_t nothing(const void *unused)
{
    (void)unused;
    return 0U;
}

static uint32_t cost(infer_t infer, uint32_t state, uint16_t *action)
{
    volatile infer_t called = infer;
    infer_t now = called;

    platform_count_from();
    *action = now(states[state]);
    return platform_count();
}

int main(void)
{
    uint16_t said = 0U;
    const uint32_t overhead = cost(nothing, 0U, &said);
    report_t done;

    for (uint32_t number = 0U; number < (uint32_t)(sizeof policies / sizeof policies[0]); number++) {
        uint32_t instructions = 0U;
        uint32_t worst = 0U;
        report_t line;

        for (uint32_t state = 0U; state < STATES; state++) {
            uint16_t first = 0U;
            uint32_t count;

            (void)cost(policies[0].infer, state, &first);
            count = cost(policies[number].infer, state, &said) - overhead;
            if (said != first) {
                return 3;
            }
            instructions += count;
            worst = (count > worst) ? count : worst;
        }
        report_begin(&line, policies[number].words);
        report_unsigned(&line, "actions", STATES);
        report_unsigned(&line, "instructions", instructions);
        report_unsigned(&line, "worst", worst);
        report_print(&line);
    }
    report_begin(&done, "done");
    report_unsigned(&done, "stack", platform_stack_used());
    report_print(&done);
    return 0;
}
