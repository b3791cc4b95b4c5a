#include "report.h"

#include "platform.h"

static void put(report_t *report, char c)
{
    if (report->length < (REPORT_LENGTH - 2U)) {
        report->text[report->length] = c;
        report->length++;
    }
}

void report_word(report_t *report, const char *word)
{
    while (*word != '\0') {
        put(report, *word);
        word++;
    }
}

void report_begin(report_t *report, const char *word)
{
    report->length = 0U;
    report_word(report, word);
}

void report_unsigned(report_t *report, const char *name, uint32_t value)
{
    char digits[10];
    uint32_t count = 0U;

    put(report, ' ');
    report_word(report, name);
    put(report, '=');
    do {
        digits[count] = (char)('0' + (int)(value % 10U));
        value /= 10U;
        count++;
    } while (value != 0U);
    while (count > 0U) {
        count--;
        put(report, digits[count]);
    }
}

void report_number(report_t *report, const char *name, int32_t value)
{
    if (value < 0) {
        put(report, ' ');
        report_word(report, name);
        report_word(report, "=-");
        /* Behind the sign: the same digits without a name. */
        char digits[10];
        uint32_t rest = 0U - (uint32_t)value;
        uint32_t count = 0U;
        do {
            digits[count] = (char)('0' + (int)(rest % 10U));
            rest /= 10U;
            count++;
        } while (rest != 0U);
        while (count > 0U) {
            count--;
            put(report, digits[count]);
        }
    } else {
        report_unsigned(report, name, (uint32_t)value);
    }
}

void report_hexadecimal(report_t *report, const char *name, uint64_t value)
{
    put(report, ' ');
    report_word(report, name);
    put(report, '=');
    for (int shift = 60; shift >= 0; shift -= 4) {
        put(report, "0123456789abcdef"[(value >> shift) & 15U]);
    }
}

void report_print(report_t *report)
{
    report->text[report->length] = '\n';
    report->text[report->length + 1U] = '\0';
    platform_print(report->text);
}
