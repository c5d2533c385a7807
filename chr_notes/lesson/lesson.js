/* Answer boxes, guesses, and the switch of the code. What it says and the units that it knows come
   before it as TABLES, from words.py; reading.py and answers.py are the same in Python. */

(() => {
  const { UNITS, WORDS } = TABLES;
  const DEGREE = Math.PI / 180;
  const { sqrt, sin, cos, tan, asin, acos, atan, atan2 } = Math;
  const NAMES = { sqrt, sin, cos, tan, asin, acos, atan, arcsin: asin, arccos: acos, arctan: atan, atan2 };
  const ARGUMENTS = (name) => (name === "atan2" ? 2 : 1);

  const fill = (words, ...parts) => parts.reduce((text, part, i) => text.replaceAll(`{${i}}`, part), words);
  const refuse = (words, ...parts) => { throw new RangeError(fill(WORDS[words], ...parts)); };

  /* Reads one expression from the left; what is left over is a unit or cannot be read. */
  class Reader {
    constructor(text) { this.rest = text.trim(); this.depth = 0; }
    takes(sign) {
      if (!this.rest.startsWith(sign)) return false;
      this.rest = this.rest.slice(sign.length).trimStart();
      return true;
    }
    unread() { return this.rest ? refuse("unread", this.rest.slice(0, 12)) : refuse("ends"); }
    total() {
      let value = this.term();
      for (;;) {
        if (this.takes("+")) value += this.term();
        else if (this.takes("-")) value -= this.term();
        else return value;
      }
    }
    term() {
      let value = this.signed();
      for (;;) {
        if (this.rest.startsWith("**")) this.unread();
        if (this.takes("*")) value *= this.signed();
        else if (this.takes("/")) {
          const by = this.signed();
          if (by === 0) refuse("no value");
          value /= by;
        } else if (this.rest.startsWith("(") || this.name()) value *= this.power();
        else return value;
      }
    }
    signed() {
      if (this.takes("-")) return -this.signed();
      return this.takes("+") ? this.signed() : this.power();
    }
    power() {
      const base = this.atom();
      return this.takes("**") || this.takes("^") ? base ** this.signed() : base;
    }
    name() {
      const found = /^[A-Za-z]+2?/.exec(this.rest)?.[0];
      return found === "pi" || Object.hasOwn(NAMES, found) ? found : "";
    }
    atom() {
      const name = this.name();
      if (name) {
        this.takes(name);
        if (name === "pi") return this.degrees(Math.PI);
        return this.degrees(NAMES[name](...this.arguments(ARGUMENTS(name))));
      }
      if (this.rest.startsWith("(")) return this.degrees(this.arguments(1)[0]);
      const found = /^(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?/.exec(this.rest)?.[0] ?? this.unread();
      this.takes(found);
      return this.degrees(Number(found));
    }
    /* Within brackets a sign of degrees belongs to the number, at the end it is the answer's. */
    degrees(value) { return this.depth && (this.takes("°") || this.takes("deg")) ? value * DEGREE : value; }
    arguments(count) {
      if (!this.takes("(")) this.unread();
      this.depth += 1;
      const values = [this.total()];
      while (this.takes(",")) values.push(this.total());
      this.depth -= 1;
      if (!this.takes(")")) this.unread();
      if (values.length !== count) refuse("no value");
      return values;
    }
  }

  const split = (text) => {
    const parts = [""];
    let depth = 0;
    for (const sign of text) {
      depth += "([".includes(sign) - ")]".includes(sign);
      if (sign === "," && depth === 0) parts.push("");
      else parts[parts.length - 1] += sign;
    }
    return parts;
  };

  /* Commas between three numbers or more that have none but white space between. */
  const spaced = (text) => {
    const numbers = /^[+-]?[\d.]+(\s+[+-]?[\d.]+){2,}(?=\s*([A-Za-zµ°%].*)?$)/.exec(text);
    if (!numbers) return text;
    return `${numbers[0].split(/\s+/).join(", ")} ${text.slice(numbers[0].length)}`;
  };

  const parts = (text) => {
    for (const [signs, plain] of [["−", "-"], ["×", "*"], ["·", "*"], ["π", "pi"], ["²", "^2"], ["μ", "µ"]]) {
      text = text.replaceAll(signs, plain);
    }
    text = text.trim();
    const vector = /^[(\[](.*)[)\]]\s*((?:[A-Za-zµ°%][^()\[\],]*)?)$/.exec(text);
    if (vector) {
      const inner = split(spaced(vector[1]));
      const count = (part, sign) => part.split(sign).length;
      if (inner.length > 1 && inner.every((part) => count(part, "(") === count(part, ")"))) {
        return [...inner.slice(0, -1), `${inner.at(-1)} ${vector[2]}`];
      }
    }
    return split(spaced(text));
  };

  const read = (text, unit = "") => {
    if (!text.trim()) refuse("empty");
    const values = [];
    let written = "";
    for (const part of parts(text)) {
      const reader = new Reader(part);
      const value = reader.total();
      if (!Number.isFinite(value)) refuse("no value");
      values.push(value);
      if (reader.rest) {
        written = reader.rest.trim();
        if (!/^[A-Za-zµ°%]/.test(written)) reader.unread();
        if (!Object.hasOwn(UNITS, written)) refuse("unknown", written, unit || "plain numbers");
      }
    }
    return [values, written];
  };

  const near = (values, others, { within, turn }) => {
    if (values.length !== others.length) return false;
    const apart = (a, b) => Math.abs(((((a - b + 180) % 360) + 360) % 360) - 180);
    if (turn) return values.every((value, i) => apart(value, others[i]) <= turn);
    const margin = within * (Math.max(...others.map(Math.abs)) || 1) + 1e-12;
    return values.every((value, i) => Math.abs(value - others[i]) <= margin);
  };

  const judge = (text, task) => {
    const { values: right, unit: asked, wrong } = task;
    try {
      const [values, unit] = read(text, asked);
      const [kind, factor] = UNITS[asked];
      const [found, share] = UNITS[unit || asked];
      if (found !== kind) return fill(WORDS.kind, found, kind);
      if (values.length !== right.length) {
        return fill(right.length > 1 ? WORDS.several : WORDS.one, right.length, values.length);
      }
      const answer = values.map((value) => (value * share) / factor);
      const opposite = answer.map((value) => -value);
      if (near(answer, right, task) || (task.either && near(opposite, right, task))) return WORDS.right;
      for (const [numbers, words] of wrong) if (near(answer, numbers, task)) return words;
      if (!unit) {
        for (const [name, [other, size]] of Object.entries(UNITS)) {
          const scaled = values.map((value) => (value * size) / factor);
          if (other === kind && near(scaled, right, task)) {
            return fill(WORDS["other unit"], name || "plain numbers", asked || "them");
          }
        }
      }
      return near(opposite, right, task) ? WORDS.sign : WORDS["not yet"];
    } catch (error) {
      if (error instanceof RangeError) return error.message;
      throw error;
    }
  };

  const compare = (text, value, asked, shown) => {
    try {
      const [values, unit] = read(text, asked);
      const [kind, factor] = UNITS[asked];
      const [found, share] = UNITS[unit || asked];
      if (found !== kind) return fill(WORDS.kind, found, kind);
      const guess = (values[0] * share) / factor;
      if (guess === 0 || value === 0) return fill(WORDS.far, shown);
      if (guess * value < 0) return fill(WORDS["other way"], shown);
      const times = value / guess;
      if (1 / 1.5 <= times && times <= 1.5) return fill(WORDS.close, shown);
      const off = Math.max(times, 1 / times);
      return fill(WORDS[times > 1 ? "under" : "over"], shown, off.toFixed(off >= 10 ? 0 : 1));
    } catch (error) {
      if (error instanceof RangeError) return error.message;
      throw error;
    }
  };

  const degrees = (text) => {
    try {
      const [[value], unit] = read(text, "°");
      const [kind, share] = UNITS[unit || "°"];
      return kind === UNITS["°"][0] ? (value * share) / DEGREE : NaN;
    } catch { return NaN; }
  };

  if (typeof document === "undefined") {
    Object.assign(globalThis, { judge, compare });
    return;
  }

  const REPLIES = {
    exercise: judge,
    guess: (text, task) => compare(text, task.value, task.unit, task.shown),
    picture: (letter, task) => task[letter],
  };

  const answer = (box) => {
    const chosen = box.closest(".chr-lesson").querySelector("input:checked");
    const text = (box.querySelector("input") ?? chosen)?.value ?? "";
    const task = JSON.parse(box.dataset.task);
    const reply = REPLIES[box.dataset.kind](text, task);
    const said = box.querySelector("output");
    said.textContent = reply;
    said.className = reply === WORDS.right ? "chr-right" : "";
    if (box.dataset.kind === "guess" && reply.includes(task.shown)) box.closest(".chr-lesson").dataset.done = "";
  };

  const start = () => {
    if ("lesson" in document.body.dataset) return; // a notebook's first cell may run twice
    document.body.dataset.lesson = "";

    // A notebook shows an output anew with each run, so listen where outputs come and go.
    const reveal = (root) => {
      for (const box of root.querySelectorAll(".chr-answer[hidden]")) {
        box.hidden = false;
        if (box.dataset.plane) arrowIn(box, degrees);
      }
    };
    reveal(document);
    new MutationObserver((changes) => {
      if (changes.some((change) => change.addedNodes.length)) reveal(document);
    }).observe(document.body, { childList: true, subtree: true });
    document.addEventListener("click", (event) => {
      const box = event.target.closest?.(".chr-answer");
      if (box && event.target.closest("button")) answer(box);
    });
    document.addEventListener("keydown", (event) => {
      const box = event.target.closest?.(".chr-answer") ?? event.target.closest?.(".chr-pictures")?.nextElementSibling;
      if (box && event.key === "Enter") answer(box);
    });

    // Who follows a link to a line of small print wants to read it.
    const open = () => {
      const target = document.getElementById(location.hash.slice(1));
      if (target?.localName === "details") target.open = true;
    };
    addEventListener("hashchange", open);
    open();

    // One switch for all code of a page: as the chapter has it, all of it, none of it.
    const heading = document.querySelector(".bd-article h1");
    if (!heading || !document.querySelector(".bd-article .cell_input")) return;
    const button = document.createElement("button");
    button.type = "button";
    button.className = "chr-code-switch";
    const show = (state) => {
      document.documentElement.dataset.code = state;
      for (const folded of document.querySelectorAll("details.hide.above-input")) folded.open = state === "all";
      button.textContent = state === "all" ? "Hide all code" : "Show all code";
      try { localStorage.setItem("chr-code", state); } catch { /* a page from the disk may keep nothing */ }
    };
    button.addEventListener("click", () => show(document.documentElement.dataset.code === "all" ? "none" : "all"));
    heading.after(button);
    let kept = null;
    try { kept = localStorage.getItem("chr-code"); } catch { /* the same */ }
    if (kept) show(kept);
    else button.textContent = "Show all code";
  };
  if (document.readyState === "loading") addEventListener("DOMContentLoaded", start);
  else start();
})();
