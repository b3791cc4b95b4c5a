/* What a network of another problem than the arm's answers to recorded observations: a hash of its values' bits. */
#include "observations.h"
#include "pendulum.h"
#include "platform.h"
#include "report.h"
#include "tpg_runtime.h"

#include <stddef.h>
#include <stdint.h>

static tpg_network_t network;
static uint32_t scratch[PENDULUM_SCRATCH];

/* One step of FNV-1a over a value's bits, as the host's; the core is little-endian. */
static uint64_t hashed(uint64_t before, float value)
{
    const uint8_t *bytes = (const uint8_t *)&value;
    uint32_t bits = 0U;

    for (uint32_t at = 0U; at < (uint32_t)sizeof value; at++) {
        bits |= (uint32_t)bytes[at] << (8U * at);
    }
    return (before ^ bits) * 0x100000001b3U;
}

int main(void)
{
    uint64_t hash = 0xcbf29ce484222325U;
    uint32_t instructions = 0U;
    uint32_t worst = 0U;
    report_t line;

    if (tpg_network_init(&network, pendulum, PENDULUM_WORDS) != TPG_OK) {
        return 2;
    }
    for (size_t at = 0U; at < OBSERVATIONS; at++) {
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
            hash = hashed(hash, values[output]);
        }
    }
    report_begin(&line, "actions pendulum");
    report_unsigned(&line, "observations", OBSERVATIONS);
    report_unsigned(&line, "instructions", instructions);
    report_unsigned(&line, "worst", worst);
    report_hexadecimal(&line, "hash", hash);
    report_print(&line);
    report_begin(&line, "done");
    report_unsigned(&line, "stack", platform_stack_used());
    report_print(&line);
    return 0;
}
