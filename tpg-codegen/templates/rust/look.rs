
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
        let {% if find.size > 0 %}windows{% else %}place{% endif %}_{{ loop.index0 }} = seen.{{ find.function }}{% if find.size > 0 %}::<{{ find.size }}>{% endif %}({{ find.channel }});
{%- endfor %}
{%- for value in look.values %}
{%- match value.feature %}
{%- when Feature::Sum with { channel, row, column, height, width } %}
        state[{{ value.input }}] = seen.sum({{ channel }}, {{ row }}, {{ column }}, {{ height }}, {{ width }}) as {{ value.kind }};
{%- when Feature::Row with (_) %}
        state[{{ value.input }}] = {{ value.place }}.row as {{ value.kind }};
{%- when Feature::Column with (_) %}
        state[{{ value.input }}] = {{ value.place }}.column as {{ value.kind }};
{%- when Feature::Contrast with (_) %}
        state[{{ value.input }}] = {{ value.place }}.contrast as {{ value.kind }};
{%- when Feature::Cell with { channel, down, right, .. } %}
        state[{{ value.input }}] = seen.from({{ channel }}, {{ value.place }}, {{ down }}, {{ right }}) as {{ value.kind }};
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

{% if !look.windows.is_empty() %}
    /// The brightest window, and the darkest.
    #[allow(dead_code)]
    pub(super) struct Windows {
        pub(super) bright: Place,
        pub(super) dark: Place,
    }
{% endif %}
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
{%- if !look.windows.is_empty() %}
        /// The windows of `SIZE` by `SIZE` cells with the greatest and with the smallest sum; the first of equal ones.
        pub(super) fn windows<const SIZE: usize>(self, channel: usize) -> Windows {
            let (down, across) = ({{ look.rows + 1 }} - SIZE, {{ look.columns + 1 }} - SIZE);
            let (mut high, mut low, mut total) = (-1, i32::MAX, 0);
            // Windows that follow, below the sum: one comparison finds the first of equal ones.
            let mut left = (down * across) as i32;
            for row in 0..down {
                let mut columns = [0; SIZE];
                for column in 0..{{ look.columns }} {
                    let top = self.cell(channel, row, column);
                    let mut newest = top;
                    for below in row + 1..row + SIZE {
                        newest += self.cell(channel, below, column);
                    }
                    total += top;
                    columns.rotate_left(1);
                    if let Some(last) = columns.last_mut() {
                        *last = newest;
                    }
                    if column + 1 >= SIZE {
                        let sum = columns.iter().sum::<u32>() as i32 * 65536;
                        left -= 1;
                        high = high.max(sum + left);
                        low = low.min(sum - left);
                    }
                }
            }
            for row in down..{{ look.rows }} {
                for column in 0..{{ look.columns }} {
                    total += self.cell(channel, row, column);
                }
            }
            let mean = (total * (SIZE * SIZE) as u32 / {{ look.rows * look.columns }}) as i32;
            let middle = |left: i32, contrast: i32| {
                let number = (down * across) as i32 - 1 - left;
                Place {
                    row: number / across as i32 + (SIZE / 2) as i32,
                    column: number % across as i32 + (SIZE / 2) as i32,
                    contrast,
                }
            };
            let lowest = (low + 65535) / 65536;
            Windows {
                bright: middle(high % 65536, high / 65536 - mean),
                dark: middle(lowest * 65536 - low, mean - lowest),
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
