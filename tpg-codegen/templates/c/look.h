/* Computes the values of the state that come from an image of {{ look.rows }} rows, {{ look.columns }} columns and {{ look.channels }} channel{% if look.channels != 1 %}s{% endif %}, a byte each, those of a
 * cell beside each other. Rows begin stride bytes apart: {{ look.columns * look.channels }} without gaps, never less. The image is not copied. */
void {{ prefix }}_look(const uint8_t *image, uint32_t stride, {{ prefix }}_state_t *state);
