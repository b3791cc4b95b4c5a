#include "{{ prefix }}.h"
#include <stdio.h>

int main(void)
{
    {{ prefix }}_state_t state;
    while (fread(&state, sizeof state, 1, stdin) == 1) {
{%- if is_choice %}
        uint16_t action = {{ prefix }}_infer(&state);
{%- else %}
        {{ prefix }}_action_t action;
        {{ prefix }}_infer(&state, &action);
{%- endif %}
        if (fwrite(&action, sizeof action, 1, stdout) != 1) {
            return 1;
        }
    }
    return 0;
}
