/* The table of all entries, looked through by document, verdict, weight, kind and words. What is
   chosen stands in the address, so that it can be kept and sent. */

document.addEventListener("DOMContentLoaded", () => {
  const marks = [...document.querySelectorAll(".ledger-overview [data-verdict]")];
  const first = document.querySelector(".ledger-overview")?.closest("section");
  if (!first) return;
  const rows = marks.map((mark) => {
    const row = mark.closest("tr");
    return { row, ...mark.dataset, words: row.textContent.toLowerCase() };
  });
  const parts = [...document.querySelectorAll(".ledger-overview")].map((part) => part.closest("section"));

  const form = document.createElement("form");
  form.className = "ledger-filter";
  form.setAttribute("role", "search");
  form.setAttribute("aria-label", "Entries of the ledger");
  const field = (name, input) => {
    const label = document.createElement("label");
    label.append(`${name[0].toUpperCase()}${name.slice(1)} `, input);
    input.name = name;
    form.append(label);
  };
  for (const name of ["document", "verdict", "weight", "kind"]) {
    const select = document.createElement("select");
    select.add(new Option("all", ""));
    for (const value of new Set(rows.map((row) => row[name]))) {
      select.add(new Option(value.replaceAll("_", " "), value));
    }
    field(name, select);
  }
  const words = document.createElement("input");
  words.type = "search";
  words.autocomplete = "off";
  field("words", words);
  const count = document.createElement("output");
  form.append(count);
  first.before(form);

  const given = new URLSearchParams(location.search);
  for (const each of form.querySelectorAll("[name]")) {
    const value = given.get(each.name) ?? "";
    if (each === words || [...each.options].some((option) => option.value === value)) each.value = value;
  }

  const look = () => {
    const chosen = Object.fromEntries(new FormData(form));
    const sought = chosen.words.toLowerCase().split(/\s+/);
    const fits = (row) => sought.every((word) => row.words.includes(word))
      && ["document", "verdict", "weight", "kind"].every((name) => !chosen[name] || row[name] === chosen[name]);
    let found = 0;
    for (const each of rows) {
      each.row.hidden = !fits(each);
      found += each.row.hidden ? 0 : 1;
    }
    for (const part of parts) part.hidden = part.querySelector("tbody tr:not([hidden])") === null;
    count.textContent = `${found} of ${rows.length} entries`;
  };
  const keep = () => {
    const chosen = new URLSearchParams([...new FormData(form)].filter(([, value]) => value));
    const query = chosen.size ? `?${chosen}` : "";
    history.replaceState(null, "", location.pathname + query);
  };
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", () => { look(); keep(); });
  look();
});
