/* The shipped policy of CartPole in every profile, in closed loop with the cart and its pole, which are generated code, too: a hash of
 * every push and observation, and the instructions of the policy. */
#include "cart.h"
#include "hash.h"
#include "platform.h"
#include "pole_balanced.h"
#include "pole_constant.h"
#include "pole_fast.h"
#include "pole_small.h"
#include "poles.h"
#include "report.h"

#include <stdint.h>

/* A policy says where to push what it sees: the cart's position and velocity, the pole's angle and angular velocity. */
typedef uint16_t (*push_t)(const cart_memory_t *seen);

#define PUSH(name)                                                                                                     \
    static uint16_t name##_push(const cart_memory_t *seen)                                                             \
    {                                                                                                                  \
        const name##_state_t state = { seen->place, seen->speed, seen->lean, seen->spin };                             \
                                                                                                                       \
        return (uint16_t)name##_infer(&state);                                                                         \
    }

PUSH(pole_fast)
PUSH(pole_balanced)
PUSH(pole_small)
PUSH(pole_constant)

static const struct {
    const char *words;
    push_t push;
} policies[] = {
    { "cost pole fast", pole_fast_push },
    { "cost pole balanced", pole_balanced_push },
    { "cost pole small", pole_small_push },
    { "cost pole constant", pole_constant_push },
};

static void run(uint32_t number)
{
    uint64_t hash = HASH_START;
    uint32_t instructions = 0U;
    uint32_t worst = 0U;
    report_t line;

    for (uint32_t episode = 0U; episode < STARTS_COUNT; episode++) {
        const float *from = starts[episode];
        cart_memory_t seen = { from[0], from[1], from[2], from[3] };

        for (uint32_t step = 0U; step < STEPS; step++) {
            uint16_t push = 0U;
            uint32_t count = 0U;
            cart_action_t shown;

            platform_count_from();
            push = policies[number].push(&seen);
            count = platform_count();
            instructions += count;
            worst = (count > worst) ? count : worst;
            {
                const cart_state_t pushed = { (float)push };

                cart_infer(&pushed, &seen, &shown);
            }
            hash = hash_bits(hash, push);
            hash = hash_value(hash, shown.x);
            hash = hash_value(hash, shown.v);
            hash = hash_value(hash, shown.theta);
            hash = hash_value(hash, shown.omega);
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
