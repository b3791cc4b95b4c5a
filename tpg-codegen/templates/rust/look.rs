
impl {{ name }} {
    /// Rows, columns and channels of the image; a cell's channels are beside each other.
    pub const IMAGE: [usize; 3] = [{{ look.rows }}, {{ look.columns }}, {{ look.channels }}];

    /// Computes the values of a state that come from an image, whose rows begin `stride` bytes apart. Returns false where the
    /// image is too short; the state is then as it was.
    pub fn look(&self, image: &[u8], stride: usize, state: &mut [{{ scalar }}; {{ state }}]) -> bool {
        let before = stride.checked_mul({{ look.rows - 1 }});
        let needed = before.and_then(|bytes| bytes.checked_add({{ look.columns * look.channels }}));
        if stride < {{ look.columns * look.channels }} || needed.is_none_or(|needed| image.len() < needed) {
            return false;
        }
        let seen = image::Image {
            bytes: image,
            stride,
        };
{%- for find in look.finds %}
        let place_{{ loop.index0 }} = seen.{{ find.function }}({{ find.channel }}{% if find.size > 0 %}, {{ find.size }}, {{ find.is_dark }}{% endif %});
{%- endfor %}
{%- for value in look.values %}
{%- match value.feature %}
{%- when Feature::Sum with { channel, row, column, height, width } %}
        state[{{ value.input }}] = seen.sum({{ channel }}, {{ row }}, {{ column }}, {{ height }}, {{ width }}) as {{ value.kind }};
{%- when Feature::Row with (_) %}
        state[{{ value.input }}] = place_{{ value.find }}.row as {{ value.kind }};
{%- when Feature::Column with (_) %}
        state[{{ value.input }}] = place_{{ value.find }}.column as {{ value.kind }};
{%- when Feature::Contrast with (_) %}
        state[{{ value.input }}] = place_{{ value.find }}.contrast as {{ value.kind }};
{%- when Feature::Cell with { channel, down, right, .. } %}
        state[{{ value.input }}] = seen.from({{ channel }}, place_{{ value.find }}, {{ down }}, {{ right }}) as {{ value.kind }};
{%- endmatch %}
{%- endfor %}
        true
    }
}

mod image {
    /// A place in an image; row −1 if there is none. A policy may read only a part of it.
    #[derive(Clone, Copy)]
    #[allow(dead_code)]
    pub(super) struct Place {
        pub(super) row: i32,
        pub(super) column: i32,
        pub(super) contrast: i32,
    }

    /// An image that is long enough.
    #[derive(Clone, Copy)]
    pub(super) struct Image<'a> {
        pub(super) bytes: &'a [u8],
        pub(super) stride: usize,
    }

    impl Image<'_> {
        fn cell(self, channel: usize, row: usize, column: usize) -> u32 {
            let place = row * self.stride + column * {{ look.channels }} + channel;
            self.bytes.get(place).map_or(0, |&byte| u32::from(byte))
        }
{% if look.has("first") %}
        /// The first cell that is not 0.
        pub(super) fn first(self, channel: usize) -> Place {
            for row in 0..{{ look.rows }} {
                for column in 0..{{ look.columns }} {
                    if self.cell(channel, row, column) != 0 {
                        return Place {
                            row: row as i32,
                            column: column as i32,
                            contrast: 0,
                        };
                    }
                }
            }
            Place {
                row: -1,
                column: -1,
                contrast: 0,
            }
        }
{% endif %}
{%- if look.has("last") %}
        /// The last cell that is not 0.
        pub(super) fn last(self, channel: usize) -> Place {
            for row in (0..{{ look.rows }}).rev() {
                for column in (0..{{ look.columns }}).rev() {
                    if self.cell(channel, row, column) != 0 {
                        return Place {
                            row: row as i32,
                            column: column as i32,
                            contrast: 0,
                        };
                    }
                }
            }
            Place {
                row: -1,
                column: -1,
                contrast: 0,
            }
        }
{% endif %}
{%- if look.has("sum") %}
        /// The sum of a window.
        pub(super) fn sum(
            self,
            channel: usize,
            row: usize,
            column: usize,
            height: usize,
            width: usize,
        ) -> u32 {
            let mut sum = 0;
            for row in row..row + height {
                for column in column..column + width {
                    sum += self.cell(channel, row, column);
                }
            }
            sum
        }
{% endif %}
{%- if look.has("window") %}
        /// The middle of the square window with the greatest sum, or with the smallest; the first of equal ones.
        pub(super) fn window(self, channel: usize, size: usize, is_dark: bool) -> Place {
            let mean = self.sum(channel, 0, 0, {{ look.rows }}, {{ look.columns }}) * (size * size) as u32 / {{ look.rows * look.columns }};
            let middle = (size / 2) as i32;
            let mut best = if is_dark { u32::MAX } else { 0 };
            let (mut down, mut right) = (middle, middle);
            for row in 0..{{ look.rows + 1 }} - size {
                for column in 0..{{ look.columns + 1 }} - size {
                    let sum = self.sum(channel, row, column, size, size);
                    if if is_dark { sum < best } else { sum > best } {
                        best = sum;
                        down = row as i32 + middle;
                        right = column as i32 + middle;
                    }
                }
            }
            let contrast = if is_dark {
                mean as i32 - best as i32
            } else {
                best as i32 - mean as i32
            };
            Place {
                row: down,
                column: right,
                contrast,
            }
        }
{% endif %}
{%- if look.has("cell") %}
        /// The cell so far down and to the right of a place; 0 outside the image.
        pub(super) fn from(self, channel: usize, from: Place, down: i32, right: i32) -> u32 {
            let (row, column) = (from.row + down, from.column + right);
            if from.row < 0 || row < 0 || row >= {{ look.rows }} || column < 0 || column >= {{ look.columns }} {
                return 0;
            }
            self.cell(channel, row as usize, column as usize)
        }
{% endif %}
    }
}
