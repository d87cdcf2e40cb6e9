// Compares two stored pictures of a block by swiping and by blinking.

export function setUpCompare(): void {
  for (const place of document.querySelectorAll<HTMLElement>(".compare")) compare(place);
}

function compare(place: HTMLElement): void {
  const pictures = place.closest("section") ?? document;
  const [first, second] = [place.dataset.first!, place.dataset.second!].map((name) =>
    pictures.querySelector<HTMLImageElement>(`[data-picture="${name}"] img`),
  );
  if (!first || !second) return;
  const under = second.cloneNode() as HTMLImageElement,
    over = first.cloneNode() as HTMLImageElement,
    box = document.createElement("div");
  over.className = "over";
  box.className = "swipe";
  box.append(under, over);
  const tools = document.createElement("div");
  tools.className = "tools swipe-tools";
  const label = document.createElement("label"),
    range = document.createElement("input"),
    blink = document.createElement("button"),
    names = document.createElement("span");
  range.type = "range";
  range.min = "0";
  range.max = "100";
  range.value = "50";
  label.append("Swipe ", range);
  blink.type = "button";
  blink.textContent = "Blink";
  blink.setAttribute("aria-pressed", "false");
  names.textContent = place.dataset.names ?? "";
  tools.append(label, blink, names);
  const show = (share: number) => (over.style.clipPath = `inset(0 ${100 - share}% 0 0)`);
  range.addEventListener("input", () => show(Number(range.value)));
  let timer = 0,
    shown = false;
  blink.addEventListener("click", () => {
    if (timer) {
      clearInterval(timer);
      timer = 0;
      show(Number(range.value));
    } else timer = window.setInterval(() => show((shown = !shown) ? 100 : 0), 600);
    blink.setAttribute("aria-pressed", String(timer !== 0));
  });
  show(50);
  place.append(tools, box);
}
