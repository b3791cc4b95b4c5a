/* One line of output, built without a heap or stdio. */
#ifndef REPORT_H
#define REPORT_H

#include <stdint.h>

#define REPORT_LENGTH 240U

typedef struct report {
    char text[REPORT_LENGTH];
    uint32_t length;
} report_t;

void report_begin(report_t *report, const char *word);
void report_word(report_t *report, const char *word);
void report_number(report_t *report, const char *name, int32_t value);
void report_unsigned(report_t *report, const char *name, uint32_t value);
void report_hexadecimal(report_t *report, const char *name, uint64_t value);
void report_print(report_t *report);

#endif
