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
    for (const char *at = word; *at != '\0'; at++) {
        put(report, *at);
    }
}

void report_begin(report_t *report, const char *word)
{
    report->length = 0U;
    report_word(report, word);
}

static const char figures[] = "0123456789abcdef";

/* ` name=` */
static void put_name(report_t *report, const char *name)
{
    put(report, ' ');
    report_word(report, name);
    put(report, '=');
}

static void put_decimal(report_t *report, uint32_t value)
{
    char digits[10];
    uint32_t count = 0U;
    uint32_t rest = value;

    do {
        digits[count] = figures[rest % 10U];
        rest /= 10U;
        count++;
    } while (rest != 0U);
    while (count > 0U) {
        count--;
        put(report, digits[count]);
    }
}

void report_unsigned(report_t *report, const char *name, uint32_t value)
{
    put_name(report, name);
    put_decimal(report, value);
}

void report_number(report_t *report, const char *name, int32_t value)
{
    put_name(report, name);
    if (value < 0) {
        put(report, '-');
        put_decimal(report, 0U - (uint32_t)value);
    } else {
        put_decimal(report, (uint32_t)value);
    }
}

void report_hexadecimal(report_t *report, const char *name, uint64_t value)
{
    put_name(report, name);
    for (uint32_t place = 0U; place < 16U; place++) {
        const uint32_t bits = 60U - (4U * place);

        put(report, figures[(value >> bits) & 15U]);
    }
}

void report_print(report_t *report)
{
    report->text[report->length] = '\n';
    report->text[report->length + 1U] = '\0';
    platform_print(report->text);
}
