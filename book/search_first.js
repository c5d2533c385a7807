/* An id of the ledger, or a word of the field, leads: FIRST, before this, has places and titles. */

document.addEventListener("DOMContentLoaded", () => {
  const asked = (new URLSearchParams(location.search).get("q") ?? "").trim().toLowerCase();
  const results = document.getElementById("search-results");
  if (!results || !Object.hasOwn(FIRST, asked)) return;
  const list = document.createElement("ul");
  list.className = "search found-first";
  list.setAttribute("aria-label", "Found first");
  for (const [place, words] of FIRST[asked]) {
    const link = document.createElement("a");
    link.href = place;
    link.textContent = words;
    const item = document.createElement("li");
    item.append(link);
    list.append(item);
  }
  results.before(list);
});

/* What Sphinx says of its search is announced as soon as it changes. */
document.addEventListener("DOMContentLoaded", () => {
  const results = document.getElementById("search-results");
  const announce = () => results.querySelector(".search-summary")?.setAttribute("role", "status");
  if (!results) return;
  announce();
  new MutationObserver(announce).observe(results, { childList: true });
});

/* A page from the disk may not fetch the others, of which a result would show a few words. */
if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
