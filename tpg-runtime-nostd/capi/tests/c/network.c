/* Prints what a network answers to each state, a line each: its values' bits, or the number of an action. */
#include "tpg_runtime.h"

#include "network.h"
#include "states.h"

#include <stdio.h>
#include <string.h>

int main(void)
{
    static uint32_t scratch[NETWORK_SCRATCH];
    static float state[NETWORK_INPUTS];
    static float values[NETWORK_OUTPUTS];
    static tpg_network_t net;
    const size_t count = sizeof states / sizeof states[0] / NETWORK_INPUTS;
    size_t inputs = 0;
    size_t outputs = 0;
    size_t words = 0;
    if (tpg_network_values(&net, state, NETWORK_INPUTS, scratch, NETWORK_SCRATCH, values, NETWORK_OUTPUTS) != TPG_STATE) {
        return 1;
    }
    if (tpg_network_init(&net, network, NETWORK_WORDS) != TPG_OK || tpg_network_inputs(&net, &inputs) != TPG_OK
        || tpg_network_outputs(&net, &outputs) != TPG_OK || tpg_network_scratch(&net, &words) != TPG_OK) {
        return 2;
    }
    if (inputs != NETWORK_INPUTS || outputs != NETWORK_OUTPUTS || words != NETWORK_SCRATCH) {
        return 3;
    }
    for (size_t at = 0; at < count; at++) {
        uint16_t action = 0;
        memcpy(state, &states[at * NETWORK_INPUTS], sizeof state);
        int32_t code = tpg_network_values(&net, state, inputs, scratch, words, values, outputs);
        if (code == TPG_OK) {
            for (size_t output = 0; output < outputs; output++) {
                uint32_t bits = 0;
                memcpy(&bits, &values[output], sizeof bits);
                printf("%08lx ", (unsigned long)bits);
            }
            printf("\n");
            if (tpg_network_choose(&net, state, inputs, scratch, words, &action) != TPG_ARGUMENT
                || tpg_network_values(&net, state, inputs - 1U, scratch, words, values, outputs) != TPG_LENGTH
                || tpg_network_values(&net, state, inputs, scratch, words - 1U, values, outputs) != TPG_LENGTH
                || tpg_network_values(&net, state, inputs, scratch, words, values, outputs - 1U) != TPG_LENGTH) {
                return 4;
            }
        } else if (code == TPG_ARGUMENT
                   && tpg_network_choose(&net, state, inputs, scratch, words, &action) == TPG_OK) {
            printf("%u\n", (unsigned)action);
            if (tpg_network_choose(&net, state, inputs, scratch, words - 1U, &action) != TPG_LENGTH
                || tpg_network_choose(&net, NULL, inputs, scratch, words, &action) != TPG_NULL) {
                return 5;
            }
        } else {
            return 6;
        }
    }
    return 0;
}
