(() => {
    // What a page can tell about itself: nothing overlaps, nothing is cut off, everything is named.
    const complaints = [];
    const all = (selector, root = document) => [...root.querySelectorAll(selector)];
    const name = element => element.id || element.closest("[id]")?.id || element.tagName;
    const root = document.documentElement;

    if (root.scrollWidth > innerWidth) complaints.push(`wider than the window: ${root.scrollWidth} px`);
    if (all("script").length) complaints.push("there is a script in the page");
    if (!root.lang) complaints.push("no language");

    // Whatever does not scroll by itself must end inside the window.
    for (const element of all("h1, h2, h3, h4, p, li, figure, nav, div, summary")) {
        if (element.closest(".scroll, .skip")) continue;
        const box = element.getBoundingClientRect();
        if (box.width && box.right > innerWidth + 1) complaints.push(`cut off: ${name(element)} ends at ${box.right}`);
    }

    const ids = new Set();
    for (const element of all("[id]")) {
        if (ids.has(element.id)) complaints.push(`id twice: ${element.id}`);
        ids.add(element.id);
    }
    const files = [];
    for (const link of all("a[href]")) {
        const to = link.getAttribute("href");
        if (to.startsWith("#")) {
            if (!ids.has(to.slice(1))) complaints.push(`link leads nowhere: ${to}`);
        } else files.push(to);
    }

    let level = 0;
    for (const heading of all("h1, h2, h3, h4, h5")) {
        const next = Number(heading.tagName[1]);
        if (next > level + 1) complaints.push(`heading skips a level: ${heading.textContent}`);
        level = next;
    }
    for (const head of all("th:not([scope])")) complaints.push(`no scope: ${head.textContent}`);

    const pictures = all("svg, img");
    for (const picture of pictures) {
        const box = picture.getBoundingClientRect();
        if (!(box.width > 0 && box.height > 0)) complaints.push(`picture of no size: ${name(picture)}`);
        if (picture.tagName === "IMG") continue;
        for (const part of ["title", "desc"]) {
            const named = picture.querySelector(part);
            const refers = named && picture.getAttribute("aria-labelledby")?.split(" ").includes(named.id);
            if (!refers || !named.textContent.trim()) complaints.push(`no ${part}: ${name(picture)}`);
        }
        // Boxes of texts are a font's height; their letters take less of it.
        const texts = all("text", picture).map(text => [text, text.getBoundingClientRect()]);
        const scale = box.width / (picture.viewBox.baseVal.width || box.width);
        texts.forEach(([one, a], index) => {
            if (a.left < box.left - 1 || a.right > box.right + 1 || a.bottom > box.bottom + 2) {
                complaints.push(`text cut off: '${one.textContent}' in ${name(picture)}`);
            }
            for (const [other, b] of texts.slice(index + 1)) {
                const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
                const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
                const height = Math.min(a.height, b.height);
                if (across > 2 * scale && down > 0.35 * height) {
                    complaints.push(`over each other: '${one.textContent}' and '${other.textContent}' in ${name(picture)}`);
                }
            }
        });
    }
    for (const figure of all("figure")) {
        if (!figure.querySelector("svg, img, a[href$='.svg']")) complaints.push(`figure without a picture: ${figure.id}`);
        if (!figure.querySelector("figcaption p")?.textContent.trim()) complaints.push(`figure without a sentence: ${figure.id}`);
    }
    return {
        complaints,
        files: [...new Set(files)],
        figures: all("figure").length,
        tables: all("table").length,
        verdicts: all("td.verdict").length,
    };
})()
