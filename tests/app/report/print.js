// The entries before and after printing.
window.dispatchEvent(new Event("beforeprint"));
var r = { printed: opened().length };
window.dispatchEvent(new Event("afterprint"));
r.after = opened().length;
result = JSON.stringify(r);
