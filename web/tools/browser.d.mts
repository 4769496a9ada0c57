import { type Browser, type Page } from "playwright-core";
export const DIST: string;
export function open(flags?: string[]): Promise<{ browser: Browser; address: string; close(): Promise<void> }>;
export function settled(page: Page): Promise<void>;
