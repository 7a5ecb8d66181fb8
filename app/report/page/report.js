// Filters, sorts and folds the ledger, keeps this state in the page's address, and gives formulas as TeX. Without this
// script the page is complete, in the paper's order.
(function () {
  "use strict";
  const find = (selector, root = document) => root.querySelector(selector);
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const said = find("#said");
  document.documentElement.dataset.js = "yes";

  // ---- the ledger

  const tools = find("#tools"), list = find("#claims");
  if (tools && list) {
    const claims = all(".claim", list), boxes = all("input[name=verdict]", tools), buttons = all("[data-sort]", tools);
    const filter = find("#filter"), severity = { refuted: 0, undecided: 1, supported: 2, proved: 3 };

    // "theorem 1" is a place: it is searched among the places of an entry, and does not match "theorem 10". Other words
    // may stand anywhere in the entry. A number matches only a whole number.
    const place = /\b(theorem|lemma|proposition|section|remark|figure|appendix)s? (\d+(?:\.\d+)?|[a-z])\b/g;
    function matches(claim, text) {
      const places = claim.dataset.place.toLowerCase(), words = `${places} ${claim.dataset.text.toLowerCase()}`;
      const named = [...text.matchAll(place)].map((m) => m[0]);
      const whole = (inside, word) => new RegExp(`(^|[^\\d.])${word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}(?!\\d|\\.\\d)`).test(inside);
      return named.every((name) => whole(places, name)) &&
        text.replace(place, " ").split(/\s+/).filter(Boolean)
          .every((word) => (/^\d+$/.test(word) ? whole(words, word) : words.includes(word)));
    }

    function show() {
      const text = filter.value.toLowerCase(), verdicts = boxes.filter((b) => b.checked).map((b) => b.value);
      claims.forEach((c) => { c.hidden = !verdicts.includes(c.dataset.verdict) || !matches(c, text); });
      find("#shown").textContent = `${claims.filter((c) => !c.hidden).length} of ${claims.length} shown`;
    }

    const before = {
      place: (a, b) => a.dataset.order - b.dataset.order,
      id: (a, b) => (a.id < b.id ? -1 : a.id > b.id ? 1 : 0),
      verdict: (a, b) => severity[a.dataset.verdict] - severity[b.dataset.verdict],
      seconds: (a, b) => b.dataset.seconds - a.dataset.seconds,
    };
    // A second click reverses the order. Equal entries keep the paper's order.
    function sort(button, down = button.dataset.direction === "up") {
      buttons.forEach((other) => {
        other.setAttribute("aria-pressed", String(other === button));
        delete other.dataset.direction;
      });
      button.dataset.direction = down ? "down" : "up";
      claims.sort((a, b) => (down ? -1 : 1) * before[button.dataset.sort](a, b) || before.place(a, b));
      list.append(...claims);
    }

    // #?q=theorem+1&hide=proved&sort=id
    function remember() {
      const state = new URLSearchParams(), button = buttons.find((b) => b.dataset.direction);
      const hidden = boxes.filter((b) => !b.checked).map((b) => b.value);
      if (filter.value) state.set("q", filter.value);
      if (hidden.length) state.set("hide", hidden.join(" "));
      if (button.dataset.sort !== "place" || button.dataset.direction === "down")
        state.set("sort", (button.dataset.direction === "down" ? "-" : "") + button.dataset.sort);
      history.replaceState(null, "", `#${state.size ? `?${state}` : "ledger"}`);
    }
    function recall() {
      if (location.hash.startsWith("#?")) {
        const state = new URLSearchParams(location.hash.slice(2)), order = state.get("sort") ?? "place";
        const hidden = (state.get("hide") ?? "").split(" ");
        filter.value = state.get("q") ?? "";
        boxes.forEach((b) => { b.checked = !hidden.includes(b.value); });
        sort(buttons.find((b) => order.endsWith(b.dataset.sort)) ?? buttons[0], order.startsWith("-"));
        show();
        find("#ledger").scrollIntoView();
        return;
      }
      const target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
      if (!target) return;
      if (target.hidden) {
        filter.value = "";
        boxes.forEach((b) => { b.checked = true; });
        show();
      }
      for (let fold = target; fold; fold = fold.parentElement) if (fold.tagName === "DETAILS") fold.open = true;
      target.scrollIntoView();
    }

    tools.addEventListener("submit", (event) => event.preventDefault());
    filter.addEventListener("input", () => { show(); remember(); });
    boxes.forEach((box) => box.addEventListener("change", () => { show(); remember(); }));
    buttons.forEach((button) => button.addEventListener("click", () => { sort(button); remember(); }));
    find("#open-all").addEventListener("click", () => claims.forEach((c) => { if (!c.hidden) c.open = true; }));
    find("#close-all").addEventListener("click", () => claims.forEach((c) => { c.open = false; }));
    window.addEventListener("hashchange", recall);
    tools.hidden = false;
    sort(buttons[0], false);
    show();
    recall();
  }

  // ---- tables: on a phone each row is a card, and each cell names its column

  all("table").forEach((table) => {
    const names = all(":scope > thead th", table).map((th) => th.textContent);
    all(":scope > tbody > tr", table).forEach((row) => {
      [...row.cells].forEach((cell, k) => { cell.dataset.label = names[k]; });
    });
  });

  // ---- printing: closed folds stay closed, unless the reader chooses "print everything"

  const everything = find("#print-all");
  everything.hidden = false;
  everything.addEventListener("click", () => {
    const closed = all("details").filter((d) => !d.open);
    closed.forEach((d) => { d.open = true; });
    window.addEventListener("afterprint", () => closed.forEach((d) => { d.open = false; }), { once: true });
    window.print();
  });

  // ---- formulas as TeX

  const greek = Object.fromEntries(
    ("α alpha β beta γ gamma δ delta ε varepsilon ζ zeta η eta θ theta ι iota κ kappa λ lambda μ mu ν nu ξ xi π pi ρ rho σ sigma " +
      "τ tau υ upsilon φ varphi χ chi ψ psi ω omega ℓ ell Γ Gamma Δ Delta Θ Theta Λ Lambda Ξ Xi Π Pi Σ Sigma Φ Phi Ψ Psi Ω Omega " +
      "∞ infty ∂ partial ∇ nabla ∅ emptyset ∫ int ∑ sum ∏ prod ∮ oint ∈ in ∉ notin ⊂ subset ≈ approx ∝ propto ≡ equiv ∪ cup " +
      "∩ cap × times ⋅ cdot ∖ setminus ≤ le ≥ ge ≠ ne ∼ sim → to ← gets ⇒ Rightarrow ⇔ Leftrightarrow ↔ leftrightarrow ↦ mapsto " +
      "± pm ∓ mp ∗ * ⟨ langle ⟩ rangle … ldots").split(" ").reduce((pairs, word, k, words) =>
      (k % 2 ? [...pairs, [words[k - 1], word === "*" ? "*" : `\\${word} `]] : pairs), []));
  const plain = { "−": "-", "′": "'", "″": "''", "‴": "'''", "≔": ":=" };
  const accents = { "‾": "bar", "˜": "tilde", "^": "hat" };
  const functions = /^(sin|cos|tan|cot|sec|csc|arcsin|arccos|arctan|sinh|cosh|tanh|log|ln|exp|max|min|sup|inf|lim|arg|det|dim|deg|limsup)$/;

  function tex(node) {
    const parts = [...node.children].map(tex), text = node.title || node.textContent;
    switch (node.localName) {
      case "mi":
        if (greek[text]) return greek[text];
        return functions.test(text) ? `\\${text} ` : text.length > 1 ? `\\mathrm{${text}}` : text;
      case "mo": return greek[text] ?? plain[text] ?? text;
      case "mn": return text;
      case "mtext": return `\\text{ ${text} }`;
      case "mspace": return parseFloat(node.getAttribute("width")) >= 0.17 ? "\\," : " ";
      case "mfrac": return `\\frac{${parts[0]}}{${parts[1]}}`;
      case "msqrt": return `\\sqrt{${parts.join("")}}`;
      case "msup": return `${parts[0]}^{${parts[1]}}`;
      case "msub": return `${parts[0]}_{${parts[1]}}`;
      case "msubsup": return `${parts[0]}_{${parts[1]}}^{${parts[2]}}`;
      case "mover": return `\\${accents[node.children[1].textContent] ?? "bar"}{${parts[0]}}`;
      default: return parts.join("");
    }
  }
  const parts = (math) => { const whole = math.closest(".f"); return whole ? all("math", whole) : [math]; };
  const texOf = (math) => parts(math).map(tex).join("").replace(/\s+(?=[\s_^{}),\]]|$)/g, "").trim();

  // Formulas in copied text become TeX.
  document.addEventListener("copy", (event) => {
    const selection = getSelection();
    if (!selection.rangeCount || selection.isCollapsed) return;
    const copied = selection.getRangeAt(0).cloneContents();
    if (!find("math", copied)) return;
    all("math", copied).forEach((math) => math.replaceWith(`$${texOf(math)}$`));
    const box = document.createElement("div");
    box.append(copied);
    event.clipboardData.setData("text/plain", box.textContent.replace(/\$\$/g, ""));
    event.preventDefault();
  });

  const panel = find("#formula"), symbols = all(".symbol");
  const leaf = (html) => html.normalize("NFD").replace(/[\u0300-\u036f]/g, "");
  const meanings = new Map();
  symbols.forEach((symbol) => leaf(symbol.textContent).split(/,\s*/).forEach((name) => {
    const key = name.match(/^(\p{L}|s_eff)/u)?.[0];
    if (key && (name.length === key.length || !meanings.has(key))) meanings.set(key, symbol);
  }));

  function close() { panel.hidden = true; }
  function button(words, act) {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = words;
    made.addEventListener("click", act);
    return made;
  }
  // A text with a button that copies it.
  function copied(text, words, tag) {
    const code = document.createElement(tag), line = document.createElement("p");
    code.textContent = text;
    line.append(button(words, () => {
      const told = () => { said.textContent = "copied"; setTimeout(() => { said.textContent = ""; }, 1500); };
      navigator.clipboard?.writeText(text).then(told, () => getSelection().selectAllChildren(code));
    }));
    return [code, line];
  }
  function show(beside, name, ...parts) {
    panel.setAttribute("aria-label", name);
    panel.replaceChildren(...parts);
    panel.hidden = false;
    const at = beside.getBoundingClientRect(), right = document.documentElement.clientWidth - panel.offsetWidth - 16;
    panel.style.left = `${Math.max(8, Math.min(at.left, right))}px`;
    panel.style.top = `${at.bottom + scrollY + 4}px`;
    panel.focus({ preventScroll: true });
  }
  function open(math) {
    const links = document.createElement("ul");
    const used = new Set(parts(math).flatMap((part) => all("mi", part)).map((mi) => mi.textContent));
    [...used].filter((name) => meanings.has(name)).forEach((name) => {
      const symbol = meanings.get(name), item = document.createElement("li"), link = document.createElement("a");
      link.href = `#${symbol.id}`;
      link.textContent = symbol.textContent;
      link.addEventListener("click", close);
      item.append(link, `: ${symbol.closest("tr").children[1].textContent}`);
      links.append(item);
    });
    show(math, "A formula", ...copied(texOf(math), "copy as TeX", "code"), links);
  }
  document.addEventListener("click", (event) => {
    const math = event.target.closest?.("math");
    if (math && getSelection().isCollapsed) {
      event.preventDefault();
      open(math);
    } else if (!event.target.closest?.("#formula, .cite")) {
      close();
    }
  });
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") close(); });

  // ---- citations of a verdict, from the pattern at the end of the page

  const pattern = all("#cite > *");
  function citable(home, words, key, what) {
    const filled = (part) => part.textContent.replace("KEY", key).replace("WHAT", what).trim();
    const cite = button(words, () => {
      const [text, bibtex] = pattern.map(filled);
      show(cite, "Citation", ...copied(text, "copy as text", "p"), ...copied(bibtex, "copy as BibTeX", "pre"));
    });
    cite.className = "cite";
    cite.setAttribute("aria-label", `cite this verdict: ${key}`);
    home.append(" ", cite);
  }
  all(".claim").forEach((claim) => citable(find(".again", claim), "cite this verdict", claim.id, `entry ${claim.id}, ${claim.dataset.verdict}`));
  all("#paper tbody > tr").forEach((row) => {
    const said = (label) => [...row.cells].find((cell) => cell.dataset.label === label);
    const verdict = said("verdict"), place = said("place")?.textContent, words = verdict.textContent;
    const name = place ? `${place} of Ballard (2016): ${said("statement").textContent}` : said("statement").textContent;
    citable(verdict, "cite", (place ?? name).toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, ""), `${name}, ${words}`);
  });

  // ---- marks the visible section in the contents

  const links = new Map(all("nav a").map((a) => [a.hash.slice(1), a]));
  const watch = new IntersectionObserver((seen) => seen.filter((s) => s.isIntersecting).forEach((s) => {
    links.forEach((link) => link.removeAttribute("aria-current"));
    links.get(s.target.id)?.setAttribute("aria-current", "true");
  }), { rootMargin: "-20% 0px -75% 0px" });
  all("section").forEach((section) => watch.observe(section));
})();
