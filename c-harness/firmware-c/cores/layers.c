/* Networks of every kind in integers, asked by cores/src/layers.rs: a hash of what they answer, and the instructions of it. */
#include "platform.h"
#include "report.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct asked {
    uint64_t hash;
    uint32_t inputs;
    uint32_t instructions;
    uint32_t worst;
} asked_t;

bool rust_layers(uint32_t code, void (*from)(void), uint32_t (*count)(void), asked_t *asked);

int main(void)
{
    static const char *const kinds[] = { "w8a16", "w16a16" };
    report_t line;

    for (uint32_t code = 0U; code < (sizeof kinds / sizeof kinds[0]); code++) {
        asked_t asked;

        if (!rust_layers(code, platform_count_from, platform_count, &asked)) {
            return 2;
        }
        report_begin(&line, "layers ");
        report_word(&line, kinds[code]);
        report_unsigned(&line, "actions", asked.inputs);
        report_hexadecimal(&line, "hash", asked.hash);
        report_unsigned(&line, "instructions", asked.instructions);
        report_unsigned(&line, "worst", asked.worst);
        report_print(&line);
    }
    report_begin(&line, "done");
    report_print(&line);
    return 0;
}
