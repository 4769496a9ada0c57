/** What the built page may load, and the page as one file. */

import { createHash } from "node:crypto";
import { type Plugin } from "vite";

const RULES = {
  "default-src": "'none'",
  "script-src": "'self' 'wasm-unsafe-eval'",
  "style-src": "'self'",
  "font-src": "'self'",
  "connect-src": "'self'",
  "img-src": "'self' data: blob:",
  "base-uri": "'none'",
  "form-action": "'none'",
};

function policy(changes: Partial<typeof RULES> = {}): string {
  return Object.entries({ ...RULES, ...changes })
    .map(([name, sources]) => `${name} ${sources}`)
    .join("; ");
}

const meta = (content: string): string =>
  `<meta http-equiv="Content-Security-Policy" content="${content}" />`;

const digest = (text: string): string =>
  `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

/** Puts a content security policy at the head of the built page. */
export function contentSecurity(): Plugin {
  return {
    name: "content-security",
    apply: "build",
    transformIndexHtml: (html) => html.replace("<!-- content security policy -->", meta(policy())),
  };
}

/** Has the kernels fetched while the script is read, which would ask for them last. */
export function kernelsEarly(): Plugin {
  return {
    name: "kernels-early",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(_, { bundle = {} }) {
        const kernels = Object.keys(bundle).find((name) => name.endsWith(".wasm"));
        if (!kernels) return [];
        const attrs = { rel: "preload", href: `./${kernels}`, as: "fetch", crossorigin: "" };
        return [{ tag: "link", attrs, injectTo: "head" }];
      },
    },
  };
}

/** Puts script and style into the page, so that it is one file that opens by itself. */
export function singleFile(): Plugin {
  return {
    name: "single-file",
    apply: "build",
    enforce: "post",
    generateBundle(_, bundle) {
      const page = bundle["index.html"];
      if (page?.type !== "asset") throw new Error("there is no index.html to put everything into");
      let html = String(page.source);
      const hashes = { script: "", style: "" };
      for (const [name, file] of Object.entries(bundle)) {
        if (file.type === "chunk") {
          const code = file.code.replaceAll("</script", "<\\/script");
          hashes.script = digest(code);
          html = html.replace(/\s*<script [^>]*src="[^"]*"[^>]*><\/script>/, "");
          html = html.replace("</body>", () => `<script type="module">${code}</script>\n  </body>`);
        } else if (name.endsWith(".css")) {
          const css = String(file.source);
          hashes.style = digest(css);
          html = html.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${css}</style>`);
        }
        if (name !== "index.html") delete bundle[name];
      }
      html = html.replace(
        meta(policy()),
        meta(
          policy({
            "script-src": `${hashes.script} 'wasm-unsafe-eval'`,
            "style-src": hashes.style,
            "font-src": "data:",
            "connect-src": "'none'",
          }),
        ),
      );
      page.source = html;
      page.fileName = "archerfish-explorer.html";
    },
  };
}
