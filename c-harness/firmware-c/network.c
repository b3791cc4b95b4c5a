/* What a network of another problem than the arm's answers to recorded observations: a hash of its values' bits. */
#include "hash.h"
#include "observations.h"
#include "pendulum.h"
#include "platform.h"
#include "report.h"
#include "tpg_runtime.h"

#include <stddef.h>
#include <stdint.h>

static tpg_network_t network;
static uint32_t scratch[PENDULUM_SCRATCH];

int main(void)
{
    uint64_t hash = HASH_START;
    uint32_t instructions = 0U;
    uint32_t worst = 0U;
    report_t line;

    if (tpg_network_init(&network, pendulum, PENDULUM_WORDS) != TPG_OK) {
        return 2;
    }
    for (size_t at = 0U; at < OBSERVATIONS_COUNT; at++) {
        float values[PENDULUM_OUTPUTS] = { 0.0F };
        uint32_t count = 0U;
        int32_t code = 0;

        platform_count_from();
        code = tpg_network_values(&network, observations[at], PENDULUM_INPUTS, scratch, PENDULUM_SCRATCH, values,
                                  PENDULUM_OUTPUTS);
        count = platform_count();
        if (code != TPG_OK) {
            return 3;
        }
        instructions += count;
        worst = (count > worst) ? count : worst;
        for (size_t output = 0U; output < PENDULUM_OUTPUTS; output++) {
            hash = hash_value(hash, values[output]);
        }
    }
    report_begin(&line, "answers pendulum");
    report_unsigned(&line, "actions", OBSERVATIONS_COUNT);
    report_unsigned(&line, "instructions", instructions);
    report_unsigned(&line, "worst", worst);
    report_hexadecimal(&line, "hash", hash);
    report_print(&line);
    report_begin(&line, "done");
    report_unsigned(&line, "stack", platform_stack_used());
    report_print(&line);
    return 0;
}
