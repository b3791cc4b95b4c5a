/* Policies that answer with values, one of them with memory, in closed loop with a pendulum, which is generated code, too:
 * a hash of every torque and observation, and the instructions of the policies. */
#include "hash.h"
#include "plant.h"
#include "platform.h"
#include "recall_balanced.h"
#include "recall_constant.h"
#include "recall_fast.h"
#include "recall_small.h"
#include "report.h"
#include "starts.h"
#include "swing_balanced.h"
#include "swing_constant.h"
#include "swing_fast.h"
#include "swing_small.h"

#include <stdint.h>

/* What the pendulum shows: cosine and sine of its angle, and its velocity. */
typedef struct seen {
    float values[3];
} seen_t;

/* A policy begins an episode, or answers with a torque. */
typedef void (*begin_t)(void);
typedef float (*torque_t)(const seen_t *seen);

#define WITHOUT_MEMORY(name)                                                                                           \
    static float name##_torque(const seen_t *seen)                                                                     \
    {                                                                                                                  \
        const name##_state_t state = { seen->values[0], seen->values[1], seen->values[2] };                            \
        name##_action_t action;                                                                                        \
                                                                                                                       \
        name##_infer(&state, &action);                                                                                 \
        return action.torque;                                                                                          \
    }

#define WITH_MEMORY(name)                                                                                              \
    static name##_memory_t name##_memory;                                                                              \
                                                                                                                       \
    static void name##_begin(void)                                                                                     \
    {                                                                                                                  \
        name##_reset(&name##_memory);                                                                                  \
    }                                                                                                                  \
                                                                                                                       \
    static float name##_torque(const seen_t *seen)                                                                     \
    {                                                                                                                  \
        const name##_state_t state = { seen->values[0], seen->values[1] };                                             \
        name##_action_t action;                                                                                        \
                                                                                                                       \
        name##_infer(&state, &name##_memory, &action);                                                                 \
        return action.torque;                                                                                          \
    }

WITHOUT_MEMORY(swing_fast)
WITHOUT_MEMORY(swing_balanced)
WITHOUT_MEMORY(swing_small)
WITHOUT_MEMORY(swing_constant)
WITH_MEMORY(recall_fast)
WITH_MEMORY(recall_balanced)
WITH_MEMORY(recall_small)
WITH_MEMORY(recall_constant)

static void nothing(void)
{
}

static const struct {
    const char *words;
    begin_t begin;
    torque_t torque;
} policies[] = {
    { "cost swing fast", nothing, swing_fast_torque },
    { "cost swing balanced", nothing, swing_balanced_torque },
    { "cost swing small", nothing, swing_small_torque },
    { "cost swing constant", nothing, swing_constant_torque },
    { "cost recall fast", recall_fast_begin, recall_fast_torque },
    { "cost recall balanced", recall_balanced_begin, recall_balanced_torque },
    { "cost recall small", recall_small_begin, recall_small_torque },
    { "cost recall constant", recall_constant_begin, recall_constant_torque },
};

/* The pendulum moves; what it shows then. */
static seen_t moved(plant_memory_t *swing, float torque)
{
    const plant_state_t state = { torque };
    plant_action_t shown;
    seen_t seen;

    plant_infer(&state, swing, &shown);
    seen.values[0] = shown.cos_theta;
    seen.values[1] = shown.sin_theta;
    seen.values[2] = shown.omega;
    return seen;
}

static void run(uint32_t number)
{
    uint64_t hash = HASH_START;
    uint32_t instructions = 0U;
    uint32_t worst = 0U;
    report_t line;

    for (uint32_t episode = 0U; episode < STARTS_COUNT; episode++) {
        /* The pendulum's angle and velocity, and what is seen of them. */
        const float *from = starts[episode];
        plant_memory_t swing = { from[0], from[1] };
        seen_t seen = { { from[2], from[3], from[4] } };

        policies[number].begin();
        for (uint32_t step = 0U; step < STEPS; step++) {
            float torque = 0.0F;
            uint32_t count = 0U;

            platform_count_from();
            torque = policies[number].torque(&seen);
            count = platform_count();
            instructions += count;
            worst = (count > worst) ? count : worst;
            seen = moved(&swing, torque);
            hash = hash_value(hash, torque);
            for (uint32_t value = 0U; value < 3U; value++) {
                hash = hash_value(hash, seen.values[value]);
            }
        }
    }
    report_begin(&line, policies[number].words);
    report_unsigned(&line, "actions", STARTS_COUNT * STEPS);
    report_unsigned(&line, "instructions", instructions);
    report_unsigned(&line, "worst", worst);
    report_hexadecimal(&line, "hash", hash);
    report_print(&line);
}

int main(void)
{
    report_t line;

    for (uint32_t number = 0U; number < (uint32_t)(sizeof policies / sizeof policies[0]); number++) {
        run(number);
    }
    report_begin(&line, "done");
    report_unsigned(&line, "stack", platform_stack_used());
    report_print(&line);
    return 0;
}
