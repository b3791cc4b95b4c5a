// Asks the policy about one state every second, after its self-test.
#include <{{ it.name }}.h>
{%- if it.memory > 0 %}

static {{ it.name }}_memory_t memory;
{%- endif %}

void setup() {
  Serial.begin(115200);
  Serial.print("self-test, wrong: ");
  Serial.println({{ it.name }}_selftest());
{%- if it.memory > 0 %}
  {{ it.name }}_reset(&memory);
{%- endif %}
}

void loop() {
  static const {{ it.name }}_state_t state = { {{ it.state_c }} };  // the middle of every range
{%- if it.outputs.is_empty() %}
  Serial.print("action ");
  Serial.println(static_cast<unsigned>({{ it.name }}_infer(&state)));
{%- else %}
  {{ it.name }}_action_t action;
  {{ it.name }}_infer(&state{% if it.memory > 0 %}, &memory{% endif %}, &action);
{%- for row in it.outputs %}
  Serial.print("{{ row.name }} ");
  Serial.println(action.{{ row.field }}{% if !it.whole %}, 6{% endif %});
{%- endfor %}
{%- endif %}
  delay(1000);
}
