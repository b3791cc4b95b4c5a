// A small chart: the distance to the target over the actions, in the colour of who drove.

/** Draws values with their drivers; the vertical axis ends at the greatest value. */
export function chart(canvas, values, colours) {
  const g = canvas.getContext("2d"), ratio = Math.min(devicePixelRatio || 1, 2);
  const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio].map(Math.round);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  g.clearRect(0, 0, width, height);
  if (!width) return;
  const most = Math.max(50, ...values.map(([value]) => value)), left = 34 * ratio, bottom = height - 4 * ratio, top = 7 * ratio;
  const x = index => left + (width - left - 4 * ratio) * index / Math.max(40, values.length - 1);
  const y = value => bottom - (bottom - top) * value / most;
  g.font = `${11 * ratio}px system-ui, sans-serif`;
  g.textAlign = "right";
  g.textBaseline = "middle";
  g.lineWidth = ratio;
  for (const value of [0, Math.round(most)]) {
    g.fillStyle = colours.soft;
    g.fillText(value, left - 6 * ratio, y(value) + (value ? 2 : -2) * ratio);
    g.strokeStyle = colours.edge;
    g.beginPath();
    g.moveTo(left, y(value));
    g.lineTo(width, y(value));
    g.stroke();
  }
  g.lineWidth = 2 * ratio;
  g.lineJoin = "round";
  for (let from = 0; from + 1 < values.length;) {
    let to = from + 1;
    while (to + 1 < values.length && values[to + 1][1] === values[to][1]) to++;
    g.beginPath();
    for (let index = from; index <= to; index++) g.lineTo(x(index), y(values[index][0]));
    g.strokeStyle = colours[values[to][1]];
    g.stroke();
    from = to;
  }
}
